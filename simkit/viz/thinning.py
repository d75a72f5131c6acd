"""Fewer rows for the same motion: what lies on a straight way between two rows is left out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

Row: TypeAlias = tuple[float, ...]
"""A time and the values at that time."""


def thinned(rows: Sequence[Row], tolerances: Sequence[float]) -> list[Row]:
    """Some of the rows, ends included; interpolation gives back every other within the tolerances.

    Args:
        rows: Times, which never fall, each with its values. Two rows of one time are a jump.
        tolerances: How far each value may be off.

    Source:
        Douglas and Peucker 1973, over time, with a stack for the recursion.
    """
    kept = {0, len(rows) - 1} if rows else set()
    spans = [(0, len(rows) - 1)]
    while spans:
        first, last = spans.pop()
        worst, error = _worst(rows, first, last, tolerances)
        if error > 1.0:
            kept.add(worst)
            spans += [(first, worst), (worst, last)]
    return [rows[index] for index in sorted(kept)]


def _worst(
    rows: Sequence[Row], first: int, last: int, tolerances: Sequence[float]
) -> tuple[int, float]:
    """The row between two others that interpolation misses most, and by how many tolerances."""
    worst, worst_error = first, 0.0
    if last - first < 2:
        return worst, worst_error
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
