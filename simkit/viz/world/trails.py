"""Trails: the way that a link went, and the way that the odometry of a robot says it went."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final

from simkit.errors import UnknownNameError
from simkit.geometry import Transform, Vector
from simkit.viz.draw.thinning import Row
from simkit.viz.marks import Marks
from simkit.viz.plots.recorded import RecordedTopics
from simkit.viz.topics.topic_marks import Shown
from simkit.viz.topics.topic_tape import TopicTrack
from simkit.viz.world.tape import WorldTape

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
