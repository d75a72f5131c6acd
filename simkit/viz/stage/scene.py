"""What a view shows, as plain data: the displays Grid, TF and RobotModel of RViz, seen from a fixed frame."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from simkit.geometry import IDENTITY, Quaternion, Vector
from simkit.msgs import Time
from simkit.tf import LATEST, Buffer
from simkit.viz.stage.camera import AXIS_SHARE, AXIS_SHARE_OF_ROBOT, Stage, stage_for
from simkit.viz.stage.frames import FramePose, TfScene, tf_scene
from simkit.viz.stage.parts import Color, Marks, Role, Solid, corners, placed_in
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.style import LOST_ALPHA, LOST_COLOR, rgb

LONGEST = 44
"""Letters of a name that are shown; of a longer one the middle is left out."""
_WHITE_LINKS = "Links without a transform are white and at the origin, as in RViz."


@dataclass(frozen=True, slots=True, kw_only=True)
class Displays:
    """Which displays are on at first; a person may turn them on and off."""

    grid: bool = True
    """The grid on the plane z = 0 of the fixed frame."""
    tf: bool = True
    """Axes, names and parents of the frames."""
    robot: Role | None = Role.VISUAL
    """Which shapes of the robot; None for none."""
    also: tuple[Role, ...] = ()
    """Which shapes besides."""
    transparent: bool | None = None
    """Whether one sees through what is seen of the links; None if a person cannot choose."""

    def shows(self, role: Role) -> bool:
        """Whether shapes of a role are seen at first."""
        return role is self.robot or role in self.also


@dataclass(frozen=True, slots=True, kw_only=True)
class Window:
    """What a view says of itself."""

    title: str
    """The program whose window it is."""
    command: str
    """What opens it again."""
    bodies: str
    """What the shapes are that are seen."""
    fixed: str
    """What the frame is called in which everything is drawn."""
    frames: str
    """What the axes are."""


RVIZ = Window(title="RViz", command="sim.rviz()", bodies="Robot", fixed="Fixed Frame", frames="TF")
"""The window of rviz."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PlacedSolid:
    """A shape of the robot with the frame that it moves with."""

    solid: Solid
    """The shape."""
    frame: FramePose | None
    """The frame of its link; None if its link is the fixed frame itself, or lost."""
    is_lost: bool
    """Whether tf does not know where its link is: it is white, and at the origin."""

    @property
    def color(self) -> Color:
        """The colour that it is drawn in."""
        return rgb(LOST_COLOR) if self.is_lost else self.solid.color

    @property
    def alpha(self) -> float:
        """The opacity that it is drawn with."""
        return min(self.solid.alpha, LOST_ALPHA) if self.is_lost else self.solid.alpha

    def pose(self) -> tuple[Vector, Quaternion]:
        """Its origin in the fixed frame [m], and how it is turned there."""
        return placed_in(self.frame, self.solid.translation, self.solid.rotation)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scene:
    """Everything that is to be seen at one moment."""

    tf: TfScene
    """The frames."""
    solids: tuple[PlacedSolid, ...]
    """The shapes of the robot."""
    problems: tuple[str, ...]
    """A sentence for each frame, link or robot that cannot be shown."""
    notes: tuple[str, ...]
    """What else there is to know."""
    displays: Displays
    """What is shown at first."""
    stage: Stage
    """Grid and camera."""
    marks: tuple[Marks, ...] = ()
    """Points and lines that are others at each moment; always the same displays, in the same order."""
    window: Window = RVIZ
    """What the view says of itself."""
    headline: str = ""
    """One sentence on what is to be seen; how many frames there are if empty."""


def make_scene(
    buffer: Buffer,
    *,
    fixed_frame: str,
    robot: RobotShapes | None = None,
    time: Time = LATEST,
    displays: Displays | None = None,
    room: Mapping[str, Sequence[Vector]] | None = None,
    complaint: str = "",
    marks: Sequence[Marks] = (),
    troubles: Sequence[str] = (),
) -> Scene:
    """What RViz would show.

    Args:
        buffer: The transforms; they say where the links are, as in RViz.
        fixed_frame: The frame that all others are seen from.
        robot: The robot; None if there is none.
        time: When; for each frame its own latest time if `Time(0)`.
        displays: What is shown at first; everything that is seen if None.
        room: Points that robots may get to [m], by the frame that they are in; the camera sees them too.
        complaint: A problem that comes before all others; empty if there is none.
        marks: What the displays of topics draw.
        troubles: A sentence for each of these that cannot.
    """
    frames = tf_scene(buffer, fixed_frame=fixed_frame, time=time, troubles=troubles)
    robot, displays = robot or RobotShapes(), displays or Displays()
    shapes = robot.solids if displays.robot is not None else ()
    poses = {pose.name: pose for pose in frames.poses}
    solids = tuple(_placed(solid, poses, fixed_frame) for solid in shapes)
    problems = dict.fromkeys(
        [*([complaint] if complaint else []), *frames.problems, *_problems(robot, poses, frames)]
    )
    notes = [*robot.notes, *_notes(solids, displays)]
    return Scene(
        tf=frames,
        solids=solids,
        problems=tuple(problems),
        notes=tuple(notes),
        displays=displays,
        marks=tuple(marks),
        stage=stage_for(
            frames,
            [*_outline(solids), *_room(room or {}, poses), *_marked(marks)],
            axis_share=AXIS_SHARE_OF_ROBOT if solids else AXIS_SHARE,
        ),
    )


def _notes(solids: Sequence[PlacedSolid], displays: Displays) -> Iterator[str]:
    if any(placed.is_lost for placed in solids):
        yield _WHITE_LINKS
    if solids and not any(displays.shows(placed.solid.role) for placed in solids):
        others = " and ".join(sorted({placed.solid.role.value for placed in solids}))
        yield f"The robot has no {displays.robot.value if displays.robot else ''} shapes, only {others} ones."


def _placed(solid: Solid, poses: Mapping[str, FramePose], fixed_frame: str) -> PlacedSolid:
    frame = poses.get(solid.link)
    # A frame seen from itself is no question, also if nobody ever broadcast it.
    is_lost = frame is None and solid.link != fixed_frame
    return PlacedSolid(solid=solid, frame=frame, is_lost=is_lost)


def _problems(robot: RobotShapes, poses: Mapping[str, FramePose], tf: TfScene) -> Iterator[str]:
    yield from robot.errors
    known = {problem.partition(":")[0] for problem in tf.problems}
    for link in robot.links:
        if link in poses or link == tf.fixed_frame:
            continue
        sentence = f"No transform from [{link}] to [{tf.fixed_frame}]"
        if sentence in known:
            continue
        yield sentence + (
            "" if tf.error else f": no node broadcasts this link{_prefixed(link, poses)}."
        )


def _prefixed(link: str, poses: Iterable[str]) -> str:
    """What to add if there is a frame that is this link of a robot with a prefix."""
    frames = [name for name in poses if name.endswith(f"/{link}")]
    if not frames:
        return ""
    prefix = frames[0].removesuffix(f"/{link}")
    return f", but there is [{frames[0]}]: the TF Prefix '{prefix}' may be missing"


def _outline(solids: Iterable[PlacedSolid]) -> Iterator[Vector]:
    for placed in solids:
        yield from corners(placed.solid, placed.frame)


def _room(room: Mapping[str, Sequence[Vector]], poses: Mapping[str, FramePose]) -> Iterator[Vector]:
    for frame, points in room.items():
        for point in points:
            yield placed_in(poses.get(frame), point, IDENTITY)[0]


def _marked(marks: Iterable[Marks]) -> Iterator[Vector]:
    for drawing in marks:
        yield from drawing.points
        for line in drawing.lines:
            yield from line
