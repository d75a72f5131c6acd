"""What a view showed from the first to the last message of a recording: where each frame was, over time."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final

from simkit.geometry import Vector
from simkit.tf import Buffer
from simkit.viz.draw.thinning import Row, thinned
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.stage.camera import AXIS_SHARE, AXIS_SHARE_OF_ROBOT, stage_for
from simkit.viz.stage.frames import FramePose, tf_scene
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.rviz_settings import RvizSettings
from simkit.viz.stage.scene import Scene, corners, make_scene
from simkit.viz.tape import TopicTape, TopicTrack

STEP_NS: Final = 33_000_000
"""The view is looked at no oftener than this [ns]."""
_TF: Final = ("/tf_static", "/tf")
_PAUSE_NS = 4 * STEP_NS
"After a silence of this length a frame has jumped, and did not move slowly."
_MOMENTS = 50
"So many times of a frame are asked how much room it needs."
_SHARE, _TURN = 0.0005, 0.0015
"Nobody sees a frame that is off by this share of the distance, or a quaternion that is off by so much."


@dataclass(frozen=True, slots=True, kw_only=True)
class RvizTape:
    """Everything that a replay shows; times count from the first message."""

    start_ns: int
    """Virtual time of the first message [ns]."""
    duration: float
    """From the first to the last message [s]."""
    scene: Scene
    """The end, with a grid and a camera for the whole."""
    tracks: tuple[tuple[Row, ...], ...]
    """For each frame of the scene: time [s], x, y, z [m], quaternion xyzw; straight in between."""
    topics: tuple[TopicTrack, ...] = ()
    """For each display of a topic, what it showed."""


def rviz_tape(
    recording: RecordedTopics, settings: RvizSettings, robot: RobotShapes | None
) -> RvizTape:
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
    tolerances = (*[_SHARE * scene.stage.camera.distance] * 3, *[_TURN] * 4)
    return RvizTape(
        start_ns=start_ns,
        duration=(end_ns - start_ns) / 1e9,
        scene=scene,
        tracks=tuple(tuple(thinned(seen[pose.name], tolerances)) for pose in scene.tf.poses),
        topics=tracks,
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
    rotation = pose.rotation
    if rows and math.fsum(a * b for a, b in zip(rows[-1][4:], rotation, strict=True)) < 0.0:
        x, y, z, w = rotation
        rotation = (-x, -y, -z, -w)  # the same turn, without a jump of the numbers
    rows.append((time, *pose.origin, *rotation))


def _with_room(
    scene: Scene, seen: Mapping[str, Sequence[Row]], tracks: Sequence[TopicTrack]
) -> Scene:
    """The scene with a stage for everything that ever was in it."""
    moments = {pose.name: list(_moments(pose, seen[pose.name])) for pose in scene.tf.poses}
    points = [moment.origin for poses in moments.values() for moment in poses]
    for placed in scene.solids:
        for moment in moments[placed.frame.name] if placed.frame is not None else (None,):
            points += corners(placed.solid, moment)
    for track in tracks:
        points += _outline(track)
    share = AXIS_SHARE_OF_ROBOT if scene.solids else AXIS_SHARE
    return replace(scene, stage=stage_for(scene.tf, points, axis_share=share))


def _outline(track: TopicTrack) -> Iterator[Vector]:
    """The corners of the box around everything that a display ever showed."""
    shown = (one for _, one in track.moments)
    points = [point for one in shown for line in (one.points, *one.lines) for point in line]
    for bound in (min, max) if points else ():
        x, y, z = (bound(values) for values in zip(*points, strict=True))
        yield x, y, z


def _moments(pose: FramePose, rows: Sequence[Row]) -> Iterator[FramePose]:
    """A frame at some of its times."""
    for _, x, y, z, *turn in rows[:: max(1, len(rows) // _MOMENTS)]:
        yield replace(pose, origin=(x, y, z), rotation=(turn[0], turn[1], turn[2], turn[3]))
