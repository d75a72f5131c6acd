"""A run of turtlesim as one HTML file: press play and watch the turtles move again.

The page has the window as SVG, buttons, and the poses as a table. Without JavaScript it shows the end.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final

from simkit.nodes.turtlesim import Frame, Stroke, Turtle, TurtlePose
from simkit.nodes.turtlesim.window import METRE_PX, SIDE, SIDE_PX, TICK, TICK_NS, hex_rgb, pixel
from simkit.viz.draw.letters import abbreviated
from simkit.viz.draw.svg import number, svg_element, svg_transform
from simkit.viz.draw.thinning import Row, thinned
from simkit.viz.page.html import escaped, html_page
from simkit.viz.replay import Replay, Track, tape_controls, track_data
from simkit.viz.turtlesim.picture import Picture, turtle_shapes

_LONGEST: Final = 30
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
    track: Track
    """x and y [px], heading counter-clockwise [degrees]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trail:
    """A line that a turtle drew without lifting or changing its pen."""

    color: str
    """Colour of the line."""
    width: float
    """Width of the line [px]."""
    track: Track
    """x and y of the point that draws [px]."""


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
                color=hex_rgb(sheet.background),
                trails=tuple(_taped_trail(stroke, start_ns) for stroke in sheet.strokes),
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
        track=Track(
            rows=tuple(thinned(rows, (_PIXELS, _PIXELS, _DEGREES))),
            until=None if gone is None else _seconds(gone, start_ns),
        ),
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


def _taped_trail(stroke: Stroke, start_ns: int) -> Trail:
    rows: list[Row] = [(_seconds(stroke.times_ns[0] - TICK_NS, start_ns), *pixel(stroke.points[0]))]
    for time_ns, point in zip(stroke.times_ns[1:], stroke.points[1:], strict=True):
        setting_off = _seconds(time_ns - TICK_NS, start_ns)
        if setting_off > rows[-1][0]:
            rows.append((setting_off, *rows[-1][1:]))
        rows.append((_seconds(time_ns, start_ns), *pixel(point)))
    return Trail(
        color=hex_rgb(stroke.pen.color),
        width=stroke.pen.width,
        track=Track(rows=tuple(thinned(rows, (_PIXELS, _PIXELS)))),
    )


def _seconds(time_ns: int, start_ns: int) -> float:
    return (time_ns - start_ns) / 1e9


class TurtleReplay(Replay):
    """The turtles and their trails from the beginning until now.

    Args:
        frame: The window of turtlesim.

    Attributes:
        tape: What is shown, as numbers.
    """

    TITLE = "Replay of turtlesim"

    def __init__(self, frame: Frame) -> None:
        self.tape: TurtleTape = turtle_tape(frame)
        self._end = Picture(frame, names=True)

    def to_html(self) -> str:
        """The replay as one HTML file; equal runs give equal text."""
        return html_page(
            title=self.TITLE,
            name="turtle_replay",
            body=_body(self.tape),
            data=_data(self.tape),
            scripts=("tape", "turtle_replay"),
        )

    def __repr__(self) -> str:
        return f"TurtleReplay({self.tape.duration:.2f} s, {len(self.tape.motions)} turtles)"

    def end_png(self) -> bytes:
        """The end as a PNG file."""
        return self._end.to_png()

    def height(self) -> int:
        """Room that the page needs inside another [px]; what is more is scrolled."""
        return 600 + 27 * min(len(self.tape.motions), 6)

    def _repr_svg_(self) -> str:
        """The end, for readers of notebooks that show no frames."""
        return self._end.to_svg()


def _body(tape: TurtleTape) -> str:
    return "\n".join([*_window(tape), *tape_controls(tape.duration), *_table(tape.motions)])


def _window(tape: TurtleTape) -> list[str]:
    sheet = tape.sheets[-1]
    count = len(tape.motions)
    return [
        f'<svg id="window" viewBox="0 0 {SIDE_PX} {SIDE_PX}" role="img" '
        f'aria-label="turtlesim with {count} turtle{"s" * (count != 1)}; their poses are in the table">',
        f'<rect id="paper" width="{SIDE_PX}" height="{SIDE_PX}" fill="{sheet.color}"/>',
        '<g id="trails" fill="none" stroke-linecap="round" stroke-linejoin="round">',
        *(_polyline(trail) for trail in sheet.trails),
        "</g>",
        *(_turtle(motion) for motion in tape.motions),
        "</svg>",
    ]


def _polyline(trail: Trail) -> str:
    points = " ".join(f"{number(x)},{number(y)}" for _, x, y in trail.track.rows)
    return (
        f'<polyline points="{points}" stroke="{trail.color}" stroke-width="{number(trail.width)}"/>'
    )


def _turtle(motion: TurtleMotion) -> str:
    track = motion.track
    _, x, y, heading = track.rows[-1] if track.rows else (0.0, 0.0, 0.0, 0.0)
    hidden = "" if track.until is None and track.rows else ' style="display:none"'
    body = "".join(svg_element(shape) for shape in turtle_shapes(motion.number))
    return (
        f'<g class="turtle"{hidden}>'
        f'<g transform="{svg_transform((x, y), -heading)}">{body}</g>'
        f'<text y="38" transform="translate({number(x)} {number(y)})">{escaped(abbreviated(motion.name, _LONGEST))}</text></g>'
    )


def _table(motions: Iterable[TurtleMotion]) -> list[str]:
    rows = [
        f'<tr><td class="name">{escaped(abbreviated(motion.name, _LONGEST))}</td>'
        "<td></td><td></td><td></td></tr>"
        for motion in motions
    ]
    head = "<tr><th>turtle</th><th>x [m]</th><th>y [m]</th><th>heading [°]</th></tr>"
    return ['<div class="wide"><table id="poses">', head, *rows, "</table></div>"] if rows else []


def _data(tape: TurtleTape) -> Mapping[str, Any]:
    return {
        "duration": tape.duration,
        "metre": METRE_PX,
        "side": SIDE,
        "sheets": [
            {
                "since": sheet.since,
                "color": sheet.color,
                "trails": [
                    {
                        "color": trail.color,
                        "width": trail.width,
                        **track_data(trail.track, digits=2),
                    }
                    for trail in sheet.trails
                ],
            }
            for sheet in tape.sheets
        ],
        "turtles": [track_data(motion.track, digits=2) for motion in tape.motions],
    }
