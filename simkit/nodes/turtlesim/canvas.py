"""The window as pixels: what a turtle's colour sensor sees.

A line covers the pixels whose centre lies in a rectangle of its width that sticks out by half a
width at both ends (Qt's square cap), without smoothing. The centre of pixel (i, j) has the
coordinates (i, j), as a turtle's position is rounded to the pixel under it.

This is our model of Qt's drawing: at the very edge of a line the two may differ by a pixel.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from simkit.nodes.turtlesim.window import SIDE_PX, Point, Rgb


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
