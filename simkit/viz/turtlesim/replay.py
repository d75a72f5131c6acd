"""A run of turtlesim as one HTML file: press play and watch the turtles move again.

The page has the window as SVG, buttons, and the poses as a table. Without JavaScript it shows the end.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Final

from simkit.nodes.turtlesim import Frame
from simkit.nodes.turtlesim.window import METRE_PX, SIDE, SIDE_PX
from simkit.viz.draw.letters import shortened
from simkit.viz.draw.svg import number, placed, svg_element
from simkit.viz.draw.thinning import Row
from simkit.viz.page.html import escaped, html_page, inline_frame
from simkit.viz.saving import save_as
from simkit.viz.tape_controls import tape_controls
from simkit.viz.turtlesim.picture import Picture, turtle_shapes
from simkit.viz.turtlesim.tape import Trail, TurtleMotion, TurtleTape, turtle_tape

_TITLE: Final = "Replay of turtlesim"
_LONGEST = 30


class TurtleReplay:
    """The turtles and their trails from the beginning until now; it does not change afterwards.

    It has a button to play, a slider over virtual time and a choice of speeds, and needs neither
    a server nor a network: it also works in a file and in a saved notebook.

    Args:
        frame: The window of turtlesim.

    Attributes:
        tape: What is shown, as numbers.
    """

    def __init__(self, frame: Frame) -> None:
        self.tape: TurtleTape = turtle_tape(frame)
        self._end = Picture(frame, names=True)

    def to_html(self) -> str:
        """The replay as one HTML file; equal runs give equal text."""
        return html_page(
            title=_TITLE,
            name="turtle_replay",
            body=_body(self.tape),
            data=_data(self.tape),
            scripts=("tape", "turtle_replay"),
        )

    def save(self, path: str | Path) -> None:
        """Write the replay to an `.html` file.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".html": self.to_html}, kind="replay format")

    def __repr__(self) -> str:
        return f"TurtleReplay({self.tape.duration:.2f} s, {len(self.tape.motions)} turtles)"

    def _repr_svg_(self) -> str:
        """The end, for readers of notebooks that show no frames."""
        return self._end.to_svg()

    def _repr_html_(self) -> str:
        return inline_frame(self.to_html(), title=_TITLE, height=_page_height(self.tape))


def _page_height(tape: TurtleTape) -> int:
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


def _turtle(motion: TurtleMotion) -> str:
    _, x, y, heading = motion.rows[-1] if motion.rows else (0.0, 0.0, 0.0, 0.0)
    hidden = "" if motion.until is None and motion.rows else ' style="display:none"'
    body = "".join(svg_element(shape) for shape in turtle_shapes(motion.number))
    return (
        f'<g class="turtle"{hidden}>'
        f'<g transform="{placed((x, y), -heading)}">{body}</g>'
        f'<text y="38" transform="translate({number(x)} {number(y)})">{escaped(shortened(motion.name, _LONGEST))}</text></g>'
    )


def _table(motions: Iterable[TurtleMotion]) -> list[str]:
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
