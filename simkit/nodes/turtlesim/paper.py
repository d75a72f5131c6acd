"""What the turtles walk and draw on: an exact record of trails, and the same lines as pixels."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from itertools import pairwise

from simkit.nodes.turtlesim.canvas import Canvas
from simkit.nodes.turtlesim.pen import Pen
from simkit.nodes.turtlesim.window import BACKGROUND, METRE_PX, SIDE, Point, Rgb


@dataclass(frozen=True, slots=True, kw_only=True)
class Stroke:
    """A trail drawn by one turtle without lifting or changing its pen."""

    turtle: str
    """Name of the turtle."""
    pen: Pen
    """Pen it was drawn with."""
    points: tuple[Point, ...]
    """Corners (x, y up) [m], in the order in which they were visited; at least two."""

    @property
    def length(self) -> float:
        """Length of the trail [m]."""
        return math.fsum(math.dist(a, b) for a, b in pairwise(self.points))


@dataclass(slots=True)
class _OpenStroke:
    turtle: str
    pen: Pen
    points: list[Point] = field(default_factory=list)


class Paper:
    """Background colour, trails, and the pixels that both make.

    Args:
        background: Colour of the empty paper.
    """

    def __init__(self, background: Rgb = BACKGROUND) -> None:
        self.background = background
        self._canvas = Canvas(background)
        self._strokes: list[_OpenStroke] = []
        self._last: dict[str, _OpenStroke] = {}

    @property
    def strokes(self) -> tuple[Stroke, ...]:
        """All trails since the paper was last cleared, in the order in which they began."""
        return tuple(
            Stroke(turtle=stroke.turtle, pen=stroke.pen, points=tuple(stroke.points))
            for stroke in self._strokes
        )

    def clear(self, background: Rgb) -> None:
        """Forget every trail and paint the paper."""
        self.background = background
        self._canvas.fill(background)
        self._strokes.clear()
        self._last.clear()

    def color_at(self, point: Point) -> Rgb:
        """Colour under a point (x, y down) [m]: of the newest line there, else the background."""
        pixel = _pixels(point)
        return self._canvas.color_at(pixel) if _is_finite(pixel) else self.background

    def draw_line(self, start: Point, end: Point, *, turtle: str, pen: Pen) -> None:
        """Draw a straight line; one that leads nowhere (not a number) is left out.

        Args:
            start: Where it begins (x, y down) [m].
            end: Where it ends (x, y down) [m].
            turtle: Name of who draws.
            pen: What it draws with.
        """
        first, last = _pixels(start), _pixels(end)
        if not (_is_finite(first) and _is_finite(last)):
            return
        self._canvas.draw_line(first, last, width=pen.width, color=pen.color)
        begin = (start[0], SIDE - start[1])
        stroke = self._last.get(turtle)
        if stroke is None or stroke.pen != pen or stroke.points[-1] != begin:
            stroke = self._last[turtle] = _OpenStroke(turtle, pen, [begin])
            self._strokes.append(stroke)
        stroke.points.append((end[0], SIDE - end[1]))


def _pixels(point: Point) -> Point:
    return (point[0] * METRE_PX, point[1] * METRE_PX)


def _is_finite(point: Point) -> bool:
    return math.isfinite(point[0]) and math.isfinite(point[1])
