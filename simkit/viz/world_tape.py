"""A recording of a world as a tape, with the trails of links and of odometry."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import count, pairwise
from typing import Any, Final

from simkit.errors import UnknownNameError
from simkit.geometry import Transform, Vector
from simkit.viz.draw.thinning import Row
from simkit.viz.plots.plot import RecordedTopics
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.parts import Marks, Role
from simkit.viz.stage.topic_marks import Shown
from simkit.viz.stage.world_scene import WorldSettings, link_poses, world_scene
from simkit.viz.stage.world_source import ForceScale, contact_marks, headline, laser_marks
from simkit.viz.tape import (
    MarksTrack,
    SceneReplay,
    SceneTape,
    pose_track,
    posed,
    sampled,
    swept_corners,
)
from simkit.viz.world_recording import ModelTrack, WorldTape

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
    """The ways that odometry reports.

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


def trail_track(number: int, way: Way) -> MarksTrack:
    """A way as a display that grows.

    Args:
        number: Its number among all trails; decides its colour.
        way: The way.
    """
    places = tuple(place for _, place in way.places)
    return MarksTrack(
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
    """Time, x, y, z, quaternion of an odometry; None if one of its numbers is invalid."""
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


_TRAILS: Final = "(trails)"
"No model has this name."


class WorldReplay(SceneReplay):
    """What the window of Gazebo showed during a recording.

    Args:
        tape: The recording.
        settings: What is seen at first; the usual if None.
        trails: Links that leave a trail: `model::link`, or `model` for its root link.
        odometry: A recording of nav_msgs/Odometry; each of its topics leaves a trail as well.

    Raises:
        UnknownNameError: There was no such link, or no model to look at, of that name.
    """

    def __init__(
        self,
        tape: WorldTape,
        settings: WorldSettings | None = None,
        *,
        trails: Sequence[str] = (),
        odometry: RecordedTopics | None = None,
    ) -> None:
        tape.look()
        settings = settings or WorldSettings()
        super().__init__(world_scene_tape(tape, settings, trails=trails, odometry=odometry))

    def __repr__(self) -> str:
        return f"WorldReplay({self.tape.duration:.2f} s, {len(self.tape.tracks)} links)"


def world_scene_tape(
    tape: WorldTape,
    settings: WorldSettings,
    *,
    trails: Sequence[str] = (),
    odometry: RecordedTopics | None = None,
) -> SceneTape:
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
    rows = {name: rows for track in tape.tracks for name, rows in track.links.items()}
    ends = {name: track.until for track in tape.tracks for name in track.links}
    return SceneTape(
        start_ns=tape.start_ns,
        duration=tape.duration,
        scene=scene,
        tracks=tuple(pose_track(scene, rows[pose.name], until=ends[pose.name]) for pose in frames),
        marks=displays,
    )


def _last_poses(track: ModelTrack) -> Iterator[FramePose]:
    if track.actor.is_ground:
        return
    for pose in link_poses(track.actor.model, name=track.actor.name):
        yield posed(pose, track.links[pose.name][-1])


def _outline(track: ModelTrack) -> Iterator[Vector]:
    """Corners of all shapes of a model, at some of its times."""
    for pose in _last_poses(track):
        moments = [*sampled(pose, track.links[pose.name]), pose]
        for solid in track.actor.shapes.solids:
            if solid.link == pose.name and solid.role in (Role.VISUAL, Role.COLLISION):
                yield from swept_corners(solid, moments)


def _happenings(tape: WorldTape, settings: WorldSettings) -> Iterator[MarksTrack]:
    """Contacts and scans; those that are not wanted are left out, since they are long."""
    scale = ForceScale([track.actor for track in tape.tracks], tape.gravity)
    if settings.contacts:
        seen = [(time, contact_marks(found, scale, is_on=True)) for time, found in tape.contacts]
        yield _display(seen, contact_marks((), scale, is_on=True))
    if settings.scans and tape.scans:
        seen = [(time, laser_marks(points, is_on=True)) for time, points in tape.scans]
        yield _display(seen, laser_marks((), is_on=True))


def _display(seen: Sequence[tuple[float, Marks]], nothing: Marks) -> MarksTrack:
    return MarksTrack(
        marks=seen[-1][1] if seen else nothing,
        moments=tuple((time, Shown(points=one.points, lines=one.lines)) for time, one in seen),
    )
