"""Fewer points for the same line: a straight run of a thousand updates becomes two points."""

from __future__ import annotations

import math
from collections.abc import Sequence

from simkit.nodes.turtlesim.window import Point


def simplified(points: Sequence[Point], tolerance: float) -> list[Point]:
    """Some of the points, ends included; every other point is within `tolerance` of their line.

    Args:
        points: Corners of a line, at least one.
        tolerance: In the unit of the points.

    Source:
        Douglas and Peucker 1973, with a stack for the recursion.
    """
    kept = {0, len(points) - 1}
    spans = [(0, len(points) - 1)]
    while spans:
        first, last = spans.pop()
        index, distance = _furthest(points, first, last)
        if distance > tolerance:
            kept.add(index)
            spans += [(first, index), (index, last)]
    return [points[index] for index in sorted(kept)]


def _furthest(points: Sequence[Point], first: int, last: int) -> tuple[int, float]:
    (ax, ay), (bx, by) = points[first], points[last]
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    worst, worst_index = 0.0, first
    for index in range(first + 1, last):
        px, py = points[index][0] - ax, points[index][1] - ay
        # Nearest point of the segment, not of the endless line: turtles turn round on trails.
        along = min(max((px * dx + py * dy) / square, 0.0), 1.0) if square else 0.0
        ex, ey = px - along * dx, py - along * dy
        error = ex * ex + ey * ey
        if error > worst:
            worst, worst_index = error, index
    return worst_index, math.sqrt(worst)
