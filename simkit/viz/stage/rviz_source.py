"""Where the scenes of RViz come from: what tf, the parameters and the topics say at this moment."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from simkit.diagnostics import Severity
from simkit.geometry import Vector
from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.tf import Buffer
from simkit.urdf import UrdfError, load_robot
from simkit.viz.stage.frames import TfScene, tf_scene
from simkit.viz.stage.parts import Marks
from simkit.viz.stage.robot import RobotShapes, robot_room, robot_shapes, together
from simkit.viz.stage.rviz_settings import DESCRIPTION, RobotDisplay, RvizSettings
from simkit.viz.stage.scene import Scene, make_scene
from simkit.viz.stage.topic_listener import TopicListeners

_MOST: Final = 6
"So many faults of a robot that is refused are listed."


def described_robot(
    value: object,
    packages: PackagePath,
    *,
    name: str = DESCRIPTION,
    alpha: float = 1.0,
    tf_prefix: str = "",
) -> RobotShapes | None:
    """The shapes of the robot that a parameter describes, or why there are none.

    Args:
        value: The value of the parameter; None if it is not set.
        packages: Where `package://` leads.
        name: The parameter.
        alpha: Opacity of the whole robot, from 0 to 1.
        tf_prefix: What stands before the names of its links in tf; empty if nothing does.

    Returns:
        None if nothing is under the usual name: most simulations have no robot, and RViz has no
        RobotModel either until somebody adds one.

    Source:
        RViz' RobotModel display: its words for what is wrong; the reason behind them is ours.
    """
    if value is None:
        if name == DESCRIPTION:
            return None
        return _nothing(f"Parameter [{name}] does not exist, and was not found by searchParam()")
    if not isinstance(value, str):
        return _nothing(f"Parameter [{name}] is no text: it should hold the URDF of a robot")
    if not value.strip():
        return _nothing("URDF is empty")
    try:
        robot = load_robot(value, file=name, packages=packages)
    except UrdfError as error:
        reason = next((line.strip() for line in str(error).splitlines() if line.strip()), "")
        return _nothing(f"URDF failed Model parse: {reason}", *_more_faults(error, reason))
    return robot_shapes(robot, alpha=alpha, tf_prefix=tf_prefix)


def _more_faults(error: UrdfError, first: str) -> Iterator[str]:
    """The other errors of a file, each in a line; of many the first ones."""
    found = [one for one in error.diagnostics if one.severity is Severity.ERROR]
    lines = [
        f"{one.file}:{one.span.line}:{one.span.column}: {one.what}; {one.remedy}" for one in found
    ]
    others = [line for line in dict.fromkeys(lines) if line != first]
    yield from others[:_MOST]
    if len(others) > _MOST:
        yield f"... and {len(others) - _MOST} more: simkit check_urdf shows them all."


def _nothing(*errors: str) -> RobotShapes:
    return RobotShapes(errors=errors)


FIRST_FRAME: Final = "map"
"""The fixed frame that RViz begins with; there, a person chooses another one in its window."""


class SceneSource:
    """Looks at a simulation; the robots are read again only when a description has changed.

    Args:
        settings: What is to be seen.
        buffer: The transforms.
        parameters: The parameter server, with the descriptions of the robots.
        packages: Where `package://` leads.
        with_room: Whether the camera leaves room for links that turn.
        listeners: What was said on the topics that are shown; without it, none are.
    """

    def __init__(
        self,
        settings: RvizSettings,
        *,
        buffer: Buffer,
        parameters: ParameterServer,
        packages: PackagePath,
        with_room: bool = False,
        listeners: TopicListeners | None = None,
    ) -> None:
        self.settings = settings
        self._buffer, self._parameters, self._packages = buffer, parameters, packages
        self._with_room, self._listeners = with_room, listeners
        self._described: object = ()
        self._robot: RobotShapes | None = None
        self._room: dict[str, tuple[Vector, ...]] = {}

    @property
    def fixed_frame(self) -> str:
        """The fixed frame; where nobody has chosen one, the one of RViz or else a root."""
        return self.settings.fixed_frame or first_frame(self._buffer)

    def scene(self) -> Scene:
        """What is to be seen now."""
        robot = self.robot()
        return make_scene(
            self._buffer,
            fixed_frame=self.fixed_frame,
            time=self.settings.time,
            robot=robot,
            displays=self.settings.displays,
            room=self._room,
            complaint=self.settings.complaint,
            marks=self.marks(),
            troubles=self._troubles(),
        )

    def frames(self) -> TfScene:
        """Where the frames are now; less work than a whole scene."""
        return tf_scene(
            self._buffer,
            fixed_frame=self.fixed_frame,
            time=self.settings.time,
            troubles=self._troubles(),
        )

    def shapes(self) -> object:
        """The shapes that hang on the frames; another object when they are others."""
        return self.robot()

    def marks(self) -> tuple[Marks, ...]:
        """What the displays of topics draw now."""
        if self._listeners is None:
            return ()
        return self._listeners.marks(self.settings.topics, self.fixed_frame)

    def _troubles(self) -> tuple[str, ...]:
        if self._listeners is None:
            return ()
        return self._listeners.troubles(self.settings.topics, self.fixed_frame)

    def robot(self) -> RobotShapes | None:
        """The robot that is described now; None if there is none."""
        if self.settings.robot_model is None:
            return None
        names = [one.description for one in self.settings.robots]
        described = [self._parameters.get(f"/{name.lstrip('/')}", None) for name in names]
        if described != self._described:
            self._described = described
            read = map(self._read, self.settings.robots, described)
            found = [robot for robot in read if robot is not None]
            self._robot = together(found) if found else None
            self._room = _room(self._robot) if self._with_room else {}
        return self._robot

    def _read(self, display: RobotDisplay, described: object) -> RobotShapes | None:
        return described_robot(
            described,
            self._packages,
            name=display.description,
            alpha=self.settings.alpha,
            tf_prefix=display.tf_prefix,
        )


def _room(robot: RobotShapes | None) -> dict[str, tuple[Vector, ...]]:
    """The room of each robot, in the frame of its root."""
    if robot is None:
        return {}
    return {
        model.frame(model.robot.root): robot_room(model, robot.solids) for model in robot.models
    }


def first_frame(buffer: Buffer) -> str:
    """`map`, with which RViz begins, unless it is not there and `world` or another root is."""
    core = buffer.core
    known = core.frame_strings
    for name in (FIRST_FRAME, "world"):
        if name in known:
            return name
    roots = [frame for frame in known if core.parent_of(frame) is None]
    return min(roots, default=FIRST_FRAME)
