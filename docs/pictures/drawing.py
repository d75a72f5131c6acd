"""Boxes, arrows and words as SVG: just what the drawings of this folder need.

Each drawing lies on a light card of its own, so that it reads on light and dark pages alike. Equal
drawings give equal text.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape
from typing import NamedTuple

FONT = "system-ui, 'Segoe UI', 'DejaVu Sans', Helvetica, Arial, sans-serif"
CODE_FONT = "ui-monospace, 'DejaVu Sans Mono', Consolas, monospace"
CARD = "#fcfbf8"
INK = "#1d2733"
MUTED = "#5a6675"
LINE_HEIGHT = 17.0

Point = tuple[float, float]


class Color(NamedTuple):
    """A pair that goes together."""

    fill: str
    edge: str


PLAIN = Color("#ffffff", "#8d99a8")
BLUE = Color("#e6e9ff", "#4556ff")
GREEN = Color("#e2f3e8", "#2e8555")
AMBER = Color("#fdf0d8", "#c17f11")
RED = Color("#fdeae8", "#c2413a")
VIOLET = Color("#f1e8fb", "#7e4bb8")


class Area(NamedTuple):
    """A rectangle [px], y down."""

    x: float
    y: float
    width: float
    height: float


class Drawing:
    """A card of a given size that shapes are put on, later ones above earlier ones.

    Args:
        title: Short name, for those who cannot see the drawing.
        description: What it shows, for them too.
        size: Width and height [px].
    """

    def __init__(self, title: str, description: str, *, size: tuple[int, int]) -> None:
        width, height = size
        self._parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"'
            f' width="{width}" height="{height}" role="img" font-family="{FONT}" font-size="13">',
            f"<title>{escape(title)}</title>",
            f"<desc>{escape(description)}</desc>",
            f'<rect x="0.5" y="0.5" width="{width - 1}" height="{height - 1}" rx="14"'
            f' fill="{CARD}" stroke="#d9d5cb"/>',
        ]

    def svg(self) -> str:
        """The whole drawing."""
        return "\n".join([*self._parts, "</svg>", ""])

    def box(
        self, area: Area, title: str, *, lines: Sequence[str] = (), color: Color = PLAIN
    ) -> None:
        """A box with a title and, below it, smaller lines, all in its middle."""
        self._rectangle(area, radius=8, fill=color.fill, edge=color.edge)
        middle = area.x + area.width / 2
        top = area.y + area.height / 2 - (len(lines) * LINE_HEIGHT) / 2 + 5
        self.words((middle, top), title, bold=True, anchor="middle")
        for number, line in enumerate(lines, 1):
            place = (middle, top + number * LINE_HEIGHT)
            self.words(place, line, size=12, color=MUTED, anchor="middle")

    def layer(self, area: Area, title: str, note: str, *, color: Color = PLAIN) -> None:
        """A flat box: a title and a note in one line."""
        self._rectangle(area, radius=8, fill=color.fill, edge=color.edge)
        middle, baseline = area.x + area.width / 2, area.y + area.height / 2 + 4.5
        self._parts.append(
            f'<text x="{_number(middle)}" y="{_number(baseline)}" text-anchor="middle"'
            f' fill="{INK}" font-weight="600">{escape(title)}'
            f'<tspan dx="10" font-size="12" font-weight="400" fill="{MUTED}">'
            f"{escape(note)}</tspan></text>"
        )

    def region(self, area: Area, title: str, *, color: Color, dashed: bool = False) -> None:
        """A large frame around other shapes, with its name in the upper left corner."""
        self._rectangle(area, radius=12, fill=f"{color.edge}0f", edge=color.edge, dashed=dashed)
        self.words((area.x + 14, area.y + 22), title, bold=True, color=color.edge)

    def words(
        self,
        place: Point,
        text: str,
        *,
        size: float = 13,
        color: str = INK,
        bold: bool = False,
        code: bool = False,
        anchor: str = "start",
    ) -> None:
        """One line of text; `place` is on its baseline."""
        extra = ' font-weight="600"' if bold else ""
        extra += f' font-family="{CODE_FONT}"' if code else ""
        extra += f' text-anchor="{anchor}"' if anchor != "start" else ""
        self._parts.append(
            f'<text x="{_number(place[0])}" y="{_number(place[1])}" font-size="{_number(size)}"'
            f' fill="{color}"{extra}>{escape(text)}</text>'
        )

    def arrow(self, points: Sequence[Point], *, color: str = INK, dashed: bool = False) -> None:
        """A line through points with a head at its end."""
        (from_x, from_y), (x, y) = points[-2:]
        angle = math.atan2(y - from_y, x - from_x)
        neck = (x - 8 * math.cos(angle), y - 8 * math.sin(angle))
        self.line([*points[:-1], neck], color=color, dashed=dashed)
        wings = [
            (x - 10 * math.cos(angle + side), y - 10 * math.sin(angle + side))
            for side in (-0.42, 0.42)
        ]
        self._parts.append(f'<polygon points="{_path([(x, y), *wings])}" fill="{color}"/>')

    def line(
        self,
        points: Sequence[Point],
        *,
        color: str = INK,
        width: float = 1.6,
        dashed: bool = False,
    ) -> None:
        """A line through points."""
        dash = ' stroke-dasharray="5 4"' if dashed else ""
        self._parts.append(
            f'<polyline points="{_path(points)}" fill="none" stroke="{color}"'
            f' stroke-width="{_number(width)}" stroke-linejoin="round"{dash}/>'
        )

    def step(self, place: Point, number: int, *, color: Color = BLUE) -> None:
        """A number in a disc: the order in which to read."""
        x, y = place
        self._parts.append(
            f'<circle cx="{_number(x)}" cy="{_number(y)}" r="11" fill="{color.edge}"/>'
        )
        self.words(
            (x, y + 4.5), str(number), size=12.5, color="#ffffff", bold=True, anchor="middle"
        )

    def bar(self, area: Area, *, color: Color) -> None:
        """A plain filled rectangle."""
        self._rectangle(area, radius=3, fill=color.fill, edge=color.edge)

    def _rectangle(
        self, area: Area, *, radius: float, fill: str, edge: str, dashed: bool = False
    ) -> None:
        dash = ' stroke-dasharray="7 5"' if dashed else ""
        self._parts.append(
            f'<rect x="{_number(area.x)}" y="{_number(area.y)}" width="{_number(area.width)}"'
            f' height="{_number(area.height)}" rx="{_number(radius)}" fill="{fill}"'
            f' stroke="{edge}" stroke-width="1.4"{dash}/>'
        )


def _path(points: Sequence[Point]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")
