"""A recording of a world as a tape, with the trails of links and of odometry."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import count, pairwise
from typing import Any, Final

from simkit.errors import UnknownNameError
from simkit.geometry import Transform, Vector
from simkit.viz.draw.thinning import Row, thinned
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.marks import Marks
from simkit.viz.stage.scene import Scene
from simkit.viz.stage.topic_marks import Shown
from simkit.viz.stage.world_scene import WorldSettings, link_poses, outline, world_scene
from simkit.viz.stage.world_source import ForceScale, contact_marks, headline, laser_marks
from simkit.viz.tape import TopicTrack
from simkit.viz.world_recording import Track, WorldTape

ODOMETRY: Final = "nav_msgs/Odometry"
"""Type of the messages that say where a robot thinks it is."""
_PAUSE: Final = 0.1
"A trail grows so often [s]."
_COLORS: Final = ("#c026a8", "#0e8a8a", "#b45309", "#4d5bd6")
_LONGEST: Final = 100_000
"A trail has no more lines."
_FAR: Final = 1e6
"Nothing is drawn farther away [m]."


@dataclass(frozen=True, slots=True, kw_only=True)
class Way:
    """Where something went."""

    label: str
    """What stands at its checkbox."""
    places: tuple[tuple[float, Vector], ...]
    """Time since the beginning of the recording [s], and place in the world [m]."""


def link_ways(tape: WorldTape, names: Iterable[str]) -> Iterator[Way]:
    """The ways of links.

    Args:
        tape: The recording.
        names: `model::link`, or `model` for its root link.

    Raises:
        UnknownNameError: There was no such model or link.
    """
    tracks = [track for track in tape.tracks if track.links]
    roots = {track.actor.name: next(iter(track.links)) for track in tracks}
    rows = {frame: rows for track in tracks for frame, rows in track.links.items()}
    for name in names:
        frame = roots.get(name, name)
        if frame not in rows:
            raise UnknownNameError("recorded model or link", name, [*roots, *rows])
        yield Way(
            label=f"Trail of {frame}",
            places=tuple((row[0], (row[1], row[2], row[3])) for row in _seldom(rows[frame])),
        )


def odometry_ways(tape: WorldTape, recording: RecordedTopics) -> Iterator[Way]:
    """The ways that odometry tells of.

    Odometry begins wherever it likes; here it begins where the link was that it is of, so that one
    sees how it drifts.

    Args:
        tape: What happened.
        recording: Of any topics; those of other types are left out.
    """
    for topic in recording.topics():
        rows = [
            row
            for time, message in recording[topic]
            if getattr(message, "_type", "") == ODOMETRY
            and (row := _row((time.to_nsec() - tape.start_ns) / 1e9, message)) is not None
        ]
        rows = [row for row in rows if row[0] >= 0.0]
        if rows:
            first = next(iter(recording[topic]))[1]
            start = _start(tape, rows[0], getattr(first, "child_frame_id", ""))
            yield Way(
                label=f"Odometry {topic}",
                places=tuple((row[0], (start @ _pose(row)).translation) for row in _seldom(rows)),
            )


def trail_track(number: int, way: Way) -> TopicTrack:
    """A way as a display that grows.

    Args:
        number: Its number among all trails; decides its colour.
        way: The way.
    """
    places = tuple(place for _, place in way.places)
    return TopicTrack(
        marks=Marks(
            name=f"trail-{number}",
            label=way.label,
            color=_COLORS[number % len(_COLORS)],
            lines=(places,),
        ),
        moments=tuple(
            (time, Shown(lines=((here, there),)))
            for (_, here), (time, there) in pairwise(way.places)
        ),
        keep=_LONGEST,
    )


def _row(time: float, message: Any) -> Row | None:
    """Time, x, y, z, quaternion of an odometry; None if there are numbers in it that are none."""
    p, q = message.pose.pose.position, message.pose.pose.orientation
    length = math.hypot(q.x, q.y, q.z, q.w)
    if not max(abs(p.x), abs(p.y), abs(p.z)) < _FAR or not 1e-9 < length < _FAR:
        return None
    return (time, p.x, p.y, p.z, q.x / length, q.y / length, q.z / length, q.w / length)


def _start(tape: WorldTape, first: Row, child: str) -> Transform:
    """Where the frame of an odometry is in the world: its first pose is that of its link."""
    for track in tape.tracks:
        link = f"{track.actor.name}::{child.strip('/')}"
        before = [row for row in track.links.get(link, ()) if row[0] <= first[0] + 1e-9]
        if before:
            return _pose(before[-1]) @ _pose(first).inverse()
    return Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))


def _pose(row: Row) -> Transform:
    _, x, y, z, a, b, c, d = row
    return Transform((x, y, z), (a, b, c, d))


def _seldom(rows: Sequence[Row]) -> list[Row]:
    """The first row, some of the others, and the last."""
    found = [rows[0]]
    for row in rows[1:]:
        if row[0] - found[-1][0] >= _PAUSE - 1e-9 or row is rows[-1]:
            found.append(row)
    return found


_MOMENTS: Final = 50
"So many times of a model are asked how much room it needs."
_SHARE, _TURN = 0.0005, 0.0015
"Nobody sees a link that is off by this share of the distance, or a quaternion that is off by so much."
_TRAILS: Final = "(trails)"
"No model has this name."


@dataclass(frozen=True, slots=True, kw_only=True)
class WorldPlay:
    """Everything that a replay shows; times count from the beginning."""

    duration: float
    """From the beginning to the end [s]."""
    scene: Scene
    """The end, with a stage for the whole."""
    tracks: tuple[tuple[Row, ...], ...]
    """For each frame of the scene: time [s], x, y, z [m], quaternion xyzw; straight in between."""
    until: tuple[float | None, ...]
    """For each frame, when it was gone [s]; None if it was there to the end."""
    displays: tuple[TopicTrack, ...]
    """For each of the marks of the scene, what it showed."""


def world_play(
    tape: WorldTape,
    settings: WorldSettings,
    *,
    trails: Sequence[str] = (),
    odometry: RecordedTopics | None = None,
) -> WorldPlay:
    """A recording, made ready to be shown.

    Args:
        tape: The recording.
        settings: What is seen at first.
        trails: Links that leave a trail: `model::link`, or `model` for its root link.
        odometry: A recording of nav_msgs/Odometry; each of its topics leaves a trail as well.

    Raises:
        UnknownNameError: There was no such link, or no model to look at, of that name.
    """
    actors = [track.actor for track in tape.tracks]
    if settings.look_at and settings.look_at not in [actor.name for actor in actors]:
        raise UnknownNameError("model", settings.look_at, [actor.name for actor in actors])
    ways = [*link_ways(tape, trails), *(odometry_ways(tape, odometry) if odometry else ())]
    displays = (*_happenings(tape, settings), *map(trail_track, count(), ways))
    frames = [pose for track in tape.tracks for pose in _last_poses(track)]
    scene = world_scene(
        actors,
        frames,
        settings,
        outlines={
            **{one.actor.name: list(_outline(one)) for one in tape.tracks},
            _TRAILS: [place for way in ways for _, place in way.places],
        },
        marks=tuple(one.marks for one in displays),
        headline=headline(actors, tape.duration),
    )
    tolerances = (*[_SHARE * scene.stage.camera.distance] * 3, *[_TURN] * 4)
    rows = {name: rows for track in tape.tracks for name, rows in track.links.items()}
    ends = {name: track.until for track in tape.tracks for name in track.links}
    return WorldPlay(
        duration=tape.duration,
        scene=scene,
        tracks=tuple(tuple(thinned(rows[pose.name], tolerances)) for pose in frames),
        until=tuple(ends[pose.name] for pose in frames),
        displays=displays,
    )


def _last_poses(track: Track) -> Iterator[FramePose]:
    if track.actor.is_ground:
        return
    for pose in link_poses(track.actor.model, name=track.actor.name):
        yield _posed(pose, track.links[pose.name][-1])


def _posed(pose: FramePose, row: Row) -> FramePose:
    _, x, y, z, a, b, c, d = row
    return replace(pose, origin=(x, y, z), rotation=(a, b, c, d))


def _outline(track: Track) -> Iterator[Vector]:
    """Corners of all shapes of a model, at some of its times."""
    if track.actor.is_ground:
        return
    poses = list(link_poses(track.actor.model, name=track.actor.name))
    rows = len(track.links[poses[0].name]) if poses else 0
    for number in [*range(0, rows, max(1, rows // _MOMENTS)), *([rows - 1] if rows else [])]:
        placed = {pose.name: _posed(pose, track.links[pose.name][number]) for pose in poses}
        yield from outline(track.actor.shapes, placed)


def _happenings(tape: WorldTape, settings: WorldSettings) -> Iterator[TopicTrack]:
    """Contacts and scans; those that are not wanted are left out, since they are long."""
    scale = ForceScale([track.actor for track in tape.tracks], tape.gravity)
    if settings.contacts:
        seen = [(time, contact_marks(found, scale, is_on=True)) for time, found in tape.contacts]
        yield _display(seen, contact_marks((), scale, is_on=True))
    if settings.scans and tape.scans:
        seen = [(time, laser_marks(points, is_on=True)) for time, points in tape.scans]
        yield _display(seen, laser_marks((), is_on=True))


def _display(seen: Sequence[tuple[float, Marks]], nothing: Marks) -> TopicTrack:
    return TopicTrack(
        marks=seen[-1][1] if seen else nothing,
        moments=tuple((time, Shown(points=one.points, lines=one.lines)) for time, one in seen),
        keep=0,
    )
