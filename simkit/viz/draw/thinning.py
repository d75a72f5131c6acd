"""Fewer points for the same line or motion: what nobody would miss is left out.

Source:
    Douglas and Peucker 1973, with a stack for the recursion.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias

from simkit.viz.draw.drawing import Point

Row: TypeAlias = tuple[float, ...]
"""A time and the values at that time."""


def thinned(rows: Sequence[Row], tolerances: Sequence[float]) -> list[Row]:
    """Some of the rows, ends included; interpolation gives back every other within the tolerances.

    Args:
        rows: Times, which never fall, each with its values. Two rows of one time are a jump.
        tolerances: How far each value may be off.
    """
    kept = _kept(len(rows), lambda first, last: _worst(rows, first, last, tolerances), 1.0)
    return [rows[index] for index in kept]


def simplified(points: Sequence[Point], tolerance: float) -> list[Point]:
    """Some of the points, ends included; every other point is within `tolerance` of their line.

    Args:
        points: Corners of a line.
        tolerance: In the unit of the points.
    """
    kept = _kept(len(points), lambda first, last: _furthest(points, first, last), tolerance)
    return [points[index] for index in kept]


def _kept(
    count: int, worst_between: Callable[[int, int], tuple[int, float]], limit: float
) -> list[int]:
    """Numbers of the ends, and of what is off by more than the limit without it."""
    kept = {0, count - 1} if count else set()
    spans = [(0, count - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        worst, error = worst_between(first, last)
        if error > limit:
            kept.add(worst)
            spans += [(first, worst), (worst, last)]
    return sorted(kept)


def _worst(
    rows: Sequence[Row], first: int, last: int, tolerances: Sequence[float]
) -> tuple[int, float]:
    """The row between two others that interpolation misses most, and by how many tolerances."""
    worst, worst_error = first, 0.0
    start, end = rows[first], rows[last]
    span = end[0] - start[0]
    slopes = [(b - a) / span if span else 0.0 for a, b in zip(start[1:], end[1:], strict=True)]
    for index in range(first + 1, last):
        row = rows[index]
        passed = row[0] - start[0]
        for value, begin, slope, tolerance in zip(
            row[1:], start[1:], slopes, tolerances, strict=True
        ):
            error = abs(begin + slope * passed - value) / tolerance
            if error > worst_error:
                worst, worst_error = index, error
    return worst, worst_error


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
