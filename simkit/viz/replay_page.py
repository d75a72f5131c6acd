"""The HTML of a replay of turtlesim: the window as SVG, buttons, and the poses as a table.

Without JavaScript it shows the end.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Final

from simkit.nodes.turtlesim.svg import svg_element
from simkit.nodes.turtlesim.turtle_shape import turtle_shapes
from simkit.nodes.turtlesim.window import METRE_PX, SIDE, SIDE_PX
from simkit.viz.letters import shortened
from simkit.viz.page import escaped, html_page
from simkit.viz.svg import number
from simkit.viz.tape_controls import tape_controls
from simkit.viz.thinning import Row
from simkit.viz.turtle_tape import Motion, Trail, TurtleTape

TITLE: Final = "Replay of turtlesim"
_LONGEST = 30


def replay_page(tape: TurtleTape) -> str:
    """The page for a run."""
    return html_page(
        title=TITLE,
        name="turtle_replay",
        body=_body(tape),
        data=_data(tape),
        scripts=("tape", "turtle_replay"),
    )


def page_height(tape: TurtleTape) -> int:
    """Room that the page needs inside another [px]; what is more is scrolled."""
    return 600 + 27 * min(len(tape.motions), 6)


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
    points = " ".join(f"{number(x)},{number(y)}" for _, x, y in trail.rows)
    return (
        f'<polyline points="{points}" stroke="{trail.color}" stroke-width="{number(trail.width)}"/>'
    )


def _turtle(motion: Motion) -> str:
    _, x, y, heading = motion.rows[-1] if motion.rows else (0.0, 0.0, 0.0, 0.0)
    hidden = "" if motion.until is None and motion.rows else ' style="display:none"'
    body = "".join(svg_element(shape) for shape in turtle_shapes(motion.number))
    place = f"translate({number(x)} {number(y)})"
    return (
        f'<g class="turtle"{hidden}>'
        f'<g transform="{place} rotate({number(-heading)})">{body}</g>'
        f'<text y="38" transform="{place}">{escaped(shortened(motion.name, _LONGEST))}</text></g>'
    )


def _table(motions: Iterable[Motion]) -> list[str]:
    rows = [
        f'<tr><td class="name">{escaped(shortened(motion.name, _LONGEST))}</td>'
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
                    {"color": trail.color, "width": trail.width, "rows": _rounded(trail.rows)}
                    for trail in sheet.trails
                ],
            }
            for sheet in tape.sheets
        ],
        "turtles": [
            {"until": motion.until, "rows": _rounded(motion.rows)} for motion in tape.motions
        ],
    }


def _rounded(rows: Iterable[Row]) -> list[list[float]]:
    return [[round(row[0], 3), *(round(value, 2) for value in row[1:])] for row in rows]
