"""What RViz showed from the first to the last message of a recording: where each frame was, and what topics said."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

from simkit.geometry import Vector
from simkit.tf import Buffer
from simkit.viz.draw.thinning import Row
from simkit.viz.plots.plot import RecordedTopics
from simkit.viz.stage.camera import AXIS_SHARE, AXIS_SHARE_OF_ROBOT, bounds, stage_for
from simkit.viz.stage.frames import FramePose, tf_scene
from simkit.viz.stage.parts import corners
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.rviz_settings import OdometryDisplay, RvizSettings, TopicDisplay
from simkit.viz.stage.scene import Scene, make_scene
from simkit.viz.stage.topic_listener import DisplayListener
from simkit.viz.stage.topic_marks import NOTHING, Shown, display_marks
from simkit.viz.tape import (
    MarksTrack,
    SceneReplay,
    SceneTape,
    pose_row,
    pose_track,
    sampled,
    swept_corners,
)

MOST_POINTS: Final = 200_000
"""A replay holds no more points of one display; of a longer recording it shows fewer moments."""
STEP_NS: Final = 33_000_000
"""The view is looked at no oftener than this [ns]."""
_TF: Final = ("/tf_static", "/tf")
_PAUSE_NS = 4 * STEP_NS
"After a silence of this length a frame has jumped, and did not move slowly."


class RvizReplay(SceneReplay):
    """What RViz showed from the first to the last message.

    Args:
        recording: Of /tf, of /tf_static if there are static transforms, and of the topics that are shown.
        settings: What is to be seen; the usual if None.
        robot: The robot; None if there is none.
    """

    def __init__(
        self,
        recording: RecordedTopics,
        settings: RvizSettings | None = None,
        *,
        robot: RobotShapes | None = None,
    ) -> None:
        super().__init__(rviz_tape(recording, settings or RvizSettings(), robot))

    def __repr__(self) -> str:
        return f"RvizReplay({self.tape.duration:.2f} s, {len(self.tape.tracks)} frames)"


def rviz_tape(
    recording: RecordedTopics, settings: RvizSettings, robot: RobotShapes | None
) -> SceneTape:
    """What RViz would have shown.

    Args:
        recording: Of /tf, and of /tf_static if there are static transforms.
        settings: What is to be seen; its time does not matter.
        robot: The robot; None if there is none.
    """
    buffer = Buffer()
    topics = TopicTape(settings.topics, buffer=buffer, fixed_frame=settings.fixed_frame)
    seen: dict[str, list[Row]] = {}
    start_ns = end_ns = 0
    for time_ns in _played(recording, buffer, topics):
        start_ns = start_ns or time_ns
        end_ns = time_ns
        for pose in tf_scene(buffer, fixed_frame=settings.fixed_frame).poses:
            _add(seen.setdefault(pose.name, []), (time_ns - start_ns) / 1e9, pose)
        topics.look((time_ns - start_ns) / 1e9)
    tracks = topics.tracks()
    scene = make_scene(
        buffer,
        fixed_frame=settings.fixed_frame,
        robot=robot,
        displays=settings.displays,
        marks=[track.marks for track in tracks],
        troubles=topics.troubles(),
    )
    scene = _with_room(scene, seen, tracks)
    return SceneTape(
        start_ns=start_ns,
        duration=(end_ns - start_ns) / 1e9,
        scene=scene,
        tracks=tuple(pose_track(scene, seen[pose.name]) for pose in scene.tf.poses),
        marks=tracks,
    )


def _played(recording: RecordedTopics, buffer: Buffer, topics: TopicTape) -> Iterator[int]:
    """Fill a buffer message by message; gives the times [ns] at which to look at it."""
    messages = _messages(recording, topics.topics)
    looked = -STEP_NS
    following = [*(time_ns for time_ns, _, _ in messages[1:]), -1]
    for (time_ns, topic, message), next_ns in zip(messages, following, strict=False):
        if topic in _TF:
            store = buffer.set_transform_static if topic == _TF[0] else buffer.set_transform
            transforms: Iterable[Any] = message.transforms
            for transform in transforms:
                store(transform, "recording")
        else:
            topics.hear(topic, message)
        if next_ns < 0 or (next_ns != time_ns and time_ns - looked >= STEP_NS):
            looked = time_ns
            yield time_ns


def _messages(recording: RecordedTopics, more: Iterable[str]) -> list[tuple[int, str, Any]]:
    topics = recording.topics()
    found = [
        (time.to_nsec(), topic, message)
        for topic in (*_TF, *more)
        if topic in topics
        for time, message in recording[topic]
    ]
    return sorted(found, key=lambda entry: entry[0])


def _add(rows: list[Row], time: float, pose: FramePose) -> None:
    """One more row; before it another one if the frame stood still in silence."""
    if rows and time - rows[-1][0] > _PAUSE_NS / 1e9:
        rows.append((time - STEP_NS / 1e9, *rows[-1][1:]))
    rows.append(pose_row(rows, time, pose.origin, pose.rotation))


def _with_room(
    scene: Scene, seen: Mapping[str, Sequence[Row]], tracks: Sequence[MarksTrack]
) -> Scene:
    """The scene with a stage for everything that ever was in it."""
    moments = {pose.name: list(sampled(pose, seen[pose.name])) for pose in scene.tf.poses}
    points = [moment.origin for poses in moments.values() for moment in poses]
    for placed in scene.solids:
        if placed.frame is None:
            points += corners(placed.solid, None)
        else:
            points += swept_corners(placed.solid, moments[placed.frame.name])
    for track in tracks:
        points += _outline(track)
    share = AXIS_SHARE_OF_ROBOT if scene.solids else AXIS_SHARE
    return replace(scene, stage=stage_for(scene.tf, points, axis_share=share))


def _outline(track: MarksTrack) -> tuple[Vector, ...]:
    """Two corners of the box around everything that a display ever showed."""
    shown = (one for _, one in track.moments)
    points = [point for one in shown for line in (one.points, *one.lines) for point in line]
    return bounds(points) if points else ()


class TopicTape:
    """Follows some displays through a recording.

    Args:
        displays: What is shown.
        buffer: The transforms, which grow meanwhile.
        fixed_frame: The frame that everything is drawn in.
    """

    def __init__(
        self, displays: Sequence[TopicDisplay], *, buffer: Buffer, fixed_frame: str
    ) -> None:
        self._displays = displays
        self._listeners = [
            DisplayListener(one, buffer=buffer, fixed_frame=fixed_frame) for one in displays
        ]
        self._moments: list[list[tuple[float, Shown]]] = [[] for _ in displays]
        self._last = [NOTHING] * len(displays)

    @property
    def topics(self) -> list[str]:
        """The topics that it wants to hear, sorted."""
        return sorted({display.topic for display in self._displays})

    def hear(self, topic: str, message: Any) -> None:
        """Take a message."""
        for display, listener in zip(self._displays, self._listeners, strict=True):
            if display.topic == topic:
                listener.hear(message)

    def look(self, time: float) -> None:
        """Keep what is to be seen at a time [s]."""
        for number, listener in enumerate(self._listeners):
            shown, last = listener.look(), self._last[number]
            if shown is not last:
                self._moments[number].append((time, _change(shown, last)))
                self._last[number] = shown

    def troubles(self) -> tuple[str, ...]:
        """What could not be shown at the end."""
        return tuple(trouble for listener in self._listeners if (trouble := listener.trouble()))

    def tracks(self) -> tuple[MarksTrack, ...]:
        """What was kept."""
        return tuple(
            MarksTrack(
                marks=display_marks(display, number, self._last[number]),
                moments=tuple(_fewer(self._moments[number])),
                keep=display.keep if isinstance(display, OdometryDisplay) else 0,
            )
            for number, display in enumerate(self._displays)
        )


def _change(shown: Shown, last: Shown) -> Shown:
    """Of a trail the lines that are new, of anything else all of it."""
    if not shown.count:
        return shown
    return Shown(lines=shown.lines[-(shown.count - last.count) :], count=shown.count)


def _fewer(moments: Sequence[tuple[float, Shown]]) -> Iterable[tuple[float, Shown]]:
    """Every second moment, or every third and so on, if there are too many points; and the last."""
    total = sum(len(shown.points) + sum(map(len, shown.lines)) for _, shown in moments)
    step = 1 + total // MOST_POINTS
    is_trail = any(shown.count for _, shown in moments)
    if step == 1 or is_trail:
        return moments
    return [*moments[:-1:step], moments[-1]]
