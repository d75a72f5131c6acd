"""The window as pixels: what a turtle's colour sensor sees.

A line covers the pixels whose centre lies in a rectangle of its width that sticks out by half a
width at both ends (Qt's square cap), without smoothing. The centre of pixel (i, j) has the
coordinates (i, j), as a turtle's position is rounded to the pixel under it.

This is our model of Qt's drawing: at the very edge of a line the two may differ by a pixel.
"""

from __future__ import annotations

import math

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
        corners = _rectangle(start, end, width / 2)
        heights = [y for _, y in corners]
        # Open below and closed above, so that the pixel nearest to the line is always in it.
        first = max(math.floor(min(heights)) + 1, 0)
        last = min(math.floor(max(heights)), SIDE_PX - 1)
        paint = bytes(color)
        for row in range(first, last + 1):
            left, right = _span(corners, row)
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


def _span(corners: list[Point], row: int) -> Point:
    crossings = []
    for index, (x, y) in enumerate(corners):
        next_x, next_y = corners[index - 1]
        low, high = min(y, next_y), max(y, next_y)
        if low <= row <= high:
            crossings.append(x if y == next_y else x + (row - y) * (next_x - x) / (next_y - y))
            if y == next_y:
                crossings.append(next_x)
    return (min(crossings), max(crossings))
