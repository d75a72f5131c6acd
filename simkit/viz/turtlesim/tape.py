"""What happened in a window of turtlesim from its beginning on: motions and trails over time."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from simkit.nodes.turtlesim import Frame, Stroke, Turtle, TurtlePose
from simkit.nodes.turtlesim.window import TICK, TICK_NS, hex_color, pixel
from simkit.viz.draw.thinning import Row, thinned

_PIXELS, _DEGREES = 0.15, 0.8
"Nobody sees a turtle that is off by so much."
_JUMP = 0.01
"A turtle that gets further in one update than its speed explains [m, rad] was teleported."


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtleMotion:
    """One turtle from its birth to its end."""

    name: str
    """Its name."""
    number: int
    """How many turtles its window made before it; decides its colour."""
    rows: tuple[Row, ...]
    """Time [s], x and y [px], heading counter-clockwise [degrees]; straight in between."""
    until: float | None
    """When it was removed [s]; None if it is still there."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trail:
    """A line that a turtle drew without lifting or changing its pen."""

    color: str
    """Colour of the line."""
    width: float
    """Width of the line [px]."""
    rows: tuple[Row, ...]
    """Time [s], x and y [px]; straight in between."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TapedSheet:
    """The paper from one clearing to the next."""

    since: float
    """When it was laid down [s]."""
    color: str
    """Colour of the empty paper."""
    trails: tuple[Trail, ...]
    """The lines on it, lowest first."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtleTape:
    """Everything that a replay shows; times count from the first update of a turtle."""

    start_ns: int
    """Virtual time of the beginning [ns]."""
    duration: float
    """From the beginning to the last update [s]."""
    motions: tuple[TurtleMotion, ...]
    """All turtles that ever were there, lowest first: in the order of their names."""
    sheets: tuple[TapedSheet, ...]
    """All papers; the last is the current one."""


def turtle_tape(frame: Frame) -> TurtleTape:
    """What happened in a window so far."""
    seen = sorted((t for t in frame.everyone if t.history), key=lambda turtle: turtle.name)
    now_ns = frame.paper.now_ns
    start_ns = min((turtle.history[0].time_ns for turtle in seen), default=now_ns)
    return TurtleTape(
        start_ns=start_ns,
        duration=(now_ns - start_ns) / 1e9,
        motions=tuple(_motion(turtle, start_ns) for turtle in seen),
        sheets=tuple(
            TapedSheet(
                since=max(sheet.from_ns - start_ns, 0) / 1e9,
                color=hex_color(sheet.background),
                trails=tuple(_trail(stroke, start_ns) for stroke in sheet.strokes),
            )
            for sheet in frame.paper.sheets
        ),
    )


def _motion(turtle: Turtle, start_ns: int) -> TurtleMotion:
    rows = [row for row in _pose_rows(turtle, start_ns) if all(map(math.isfinite, row))]
    gone = turtle.gone_ns
    return TurtleMotion(
        name=turtle.name,
        number=turtle.number,
        rows=tuple(thinned(rows, (_PIXELS, _PIXELS, _DEGREES))),
        until=None if gone is None else (gone - start_ns) / 1e9,
    )


def _pose_rows(turtle: Turtle, start_ns: int) -> Iterator[Row]:
    """A row for each entry of the history, and one more before a turtle sets off or jumps."""
    first = turtle.history[0]
    heading = first.pose.theta
    yield _pose_row(first.time_ns - start_ns, first.pose, heading)
    for before, after in pairwise(turtle.history):
        turned = math.remainder(after.pose.theta - before.pose.theta, 2 * math.pi)
        if _is_jump(before.pose, after.pose, turned):
            yield _pose_row(after.time_ns - start_ns, before.pose, heading)
        elif after.time_ns - before.time_ns > TICK_NS:
            yield _pose_row(after.time_ns - TICK_NS - start_ns, before.pose, heading)
        heading += turned
        yield _pose_row(after.time_ns - start_ns, after.pose, heading)


def _pose_row(time_ns: int, pose: TurtlePose, heading: float) -> Row:
    return (time_ns / 1e9, *pixel((pose.x, pose.y)), math.degrees(heading))


def _is_jump(before: TurtlePose, after: TurtlePose, turned: float) -> bool:
    moved = math.dist((before.x, before.y), (after.x, after.y))
    return (
        moved > after.linear_velocity * TICK + _JUMP
        or abs(turned) > abs(after.angular_velocity) * TICK + _JUMP
    )


def _trail(stroke: Stroke, start_ns: int) -> Trail:
    rows: list[Row] = [(_seconds(stroke.times_ns[0] - TICK_NS, start_ns), *pixel(stroke.points[0]))]
    for time_ns, point in zip(stroke.times_ns[1:], stroke.points[1:], strict=True):
        setting_off = _seconds(time_ns - TICK_NS, start_ns)
        if setting_off > rows[-1][0]:
            rows.append((setting_off, *rows[-1][1:]))
        rows.append((_seconds(time_ns, start_ns), *pixel(point)))
    return Trail(
        color=hex_color(stroke.pen.color),
        width=stroke.pen.width,
        rows=tuple(thinned(rows, (_PIXELS, _PIXELS))),
    )


def _seconds(time_ns: int, start_ns: int) -> float:
    return (time_ns - start_ns) / 1e9
