"""What the turtles walk and draw on: an exact record of trails, and the same lines as pixels.

A turtle's colour sensor sees the pixels. A line covers those whose centre lies in a rectangle of its
width that sticks out by half a width at both ends (Qt's square cap), without smoothing. The centre of
pixel (i, j) has the coordinates (i, j), as a turtle's position is rounded to the pixel under it.

This is our model of Qt's drawing: at the very edge of a line the two may differ by a pixel.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

from simkit.nodes.turtlesim.state import Pen
from simkit.nodes.turtlesim.window import BACKGROUND, METRE_PX, SIDE, SIDE_PX, Point, Rgb


@dataclass(frozen=True, slots=True, kw_only=True)
class Stroke:
    """A trail drawn by one turtle without lifting or changing its pen."""

    turtle: str
    """Name of the turtle."""
    pen: Pen
    """Pen it was drawn with."""
    points: tuple[Point, ...]
    """Corners (x, y up) [m], in the order in which they were visited; at least two."""
    times_ns: tuple[int, ...]
    """Virtual time of the update that drew up to each corner [ns]; the first two are equal."""

    @property
    def length(self) -> float:
        """Length of the trail [m]."""
        return math.fsum(math.dist(a, b) for a, b in pairwise(self.points))


@dataclass(frozen=True, slots=True, kw_only=True)
class PaperSheet:
    """The paper from one clearing to the next."""

    from_ns: int
    """Virtual time at which it was laid down [ns]; 0 for the first."""
    background: Rgb
    """Colour of the empty paper."""
    strokes: tuple[Stroke, ...]
    """Trails on it, in the order in which they began."""


@dataclass(slots=True)
class _OpenStroke:
    turtle: str
    pen: Pen
    points: list[Point]
    times_ns: list[int]

    def closed(self) -> Stroke:
        return Stroke(
            turtle=self.turtle,
            pen=self.pen,
            points=tuple(self.points),
            times_ns=tuple(self.times_ns),
        )


class Paper:
    """Background colour, trails, and the pixels that both make.

    Args:
        background: Colour of the empty paper.

    Attributes:
        now_ns: Virtual time of whatever is drawn or cleared next [ns]; the frame keeps it.
    """

    def __init__(self, background: Rgb = BACKGROUND) -> None:
        self.background = background
        self.now_ns = 0
        self._canvas = Canvas(background)
        self._cleared: list[PaperSheet] = []
        self._from_ns = 0
        self._strokes: list[_OpenStroke] = []
        self._last: dict[str, _OpenStroke] = {}

    @property
    def strokes(self) -> tuple[Stroke, ...]:
        """All trails since the paper was last cleared, in the order in which they began."""
        return tuple(stroke.closed() for stroke in self._strokes)

    @property
    def sheets(self) -> tuple[PaperSheet, ...]:
        """The paper before each clearing and, last, as it is now."""
        return (*self._cleared, self._sheet())

    def clear(self, background: Rgb) -> None:
        """Take every trail off the paper and paint it."""
        self._cleared.append(self._sheet())
        self._from_ns = self.now_ns
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
            stroke = self._last[turtle] = _OpenStroke(turtle, pen, [begin], [self.now_ns])
            self._strokes.append(stroke)
        stroke.points.append((end[0], SIDE - end[1]))
        stroke.times_ns.append(self.now_ns)

    def _sheet(self) -> PaperSheet:
        return PaperSheet(from_ns=self._from_ns, background=self.background, strokes=self.strokes)


def _pixels(point: Point) -> Point:
    return (point[0] * METRE_PX, point[1] * METRE_PX)


def _is_finite(point: Point) -> bool:
    return math.isfinite(point[0]) and math.isfinite(point[1])


class Canvas:
    """The window's pixels, three bytes each, upper row first.

    Args:
        color: What every pixel is at first.
    """

    def __init__(self, color: Rgb) -> None:
        self._pixels = bytearray()
        self.fill(color)

    def fill(self, color: Rgb) -> None:
        """Paint every pixel."""
        self._pixels[:] = bytes(color) * (SIDE_PX * SIDE_PX)

    def color_at(self, point: Point) -> Rgb:
        """Colour of the pixel nearest to a point (x, y down) [px] of the window."""
        column, row = (min(max(math.floor(value + 0.5), 0), SIDE_PX - 1) for value in point)
        start = 3 * (row * SIDE_PX + column)
        red, green, blue = self._pixels[start : start + 3]
        return (red, green, blue)

    def draw_line(self, start: Point, end: Point, *, width: int, color: Rgb) -> None:
        """Paint a straight line from `start` to `end` (x, y down) [px], `width` [px] wide."""
        edges = _edges(_rectangle(start, end, width / 2))
        # Open below and closed above, so that the pixel nearest to the line is always in it.
        first = max(math.floor(min(edges)[0]) + 1, 0)
        last = min(math.floor(max(edge[1] for edge in edges)), SIDE_PX - 1)
        paint = bytes(color)
        for row in range(first, last + 1):
            left, right = _span(edges, row)
            begin = max(math.floor(left) + 1, 0)
            stop = min(math.floor(right), SIDE_PX - 1) + 1
            if begin < stop:
                offset = 3 * row * SIDE_PX
                self._pixels[offset + 3 * begin : offset + 3 * stop] = paint * (stop - begin)


def _rectangle(start: Point, end: Point, half: float) -> list[Point]:
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    ux, uy = (dx / length * half, dy / length * half) if length else (half, 0.0)
    return [
        (start[0] - ux - uy, start[1] - uy + ux),
        (start[0] - ux + uy, start[1] - uy - ux),
        (end[0] + ux + uy, end[1] + uy - ux),
        (end[0] + ux - uy, end[1] + uy + ux),
    ]


_Edge: TypeAlias = tuple[float, float, float, float, float, float]
"""Lowest and highest y of a side of the rectangle, and its two ends."""


def _edges(corners: list[Point]) -> list[_Edge]:
    sides = zip(corners, (corners[-1], *corners), strict=False)
    return [
        (y, to, x, y, x2, to) if y < to else (to, y, x, y, x2, to) for (x, y), (x2, to) in sides
    ]


def _span(edges: list[_Edge], row: int) -> Point:
    """Where a row enters and leaves the rectangle. A turtle draws at every tick: this is written to be quick."""
    left, right = math.inf, -math.inf
    for low, high, x, y, next_x, next_y in edges:
        if low <= row <= high:
            if y == next_y:
                left, right = min(left, x, next_x), max(right, x, next_x)
                continue
            crossing = x + (row - y) * (next_x - x) / (next_y - y)
            if crossing < left:
                left = crossing
            if crossing > right:
                right = crossing
    return (left, right)
