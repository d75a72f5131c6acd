from __future__ import annotations

import math
from itertools import pairwise

from simkit.nodes.turtlesim.simplify import simplified


def test_a_straight_run_becomes_its_two_ends() -> None:
    points = [(0.72 * step, 0.36 * step) for step in range(1000)]
    assert simplified(points, 0.05) == [points[0], points[-1]]


def test_turning_round_on_the_spot_keeps_the_turning_point() -> None:
    points = [(float(x), 0.0) for x in [*range(10), *range(9, 3, -1)]]
    assert simplified(points, 0.05) == [(0.0, 0.0), (9.0, 0.0), (4.0, 0.0)]


def test_a_closed_way_is_kept() -> None:
    square = [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0), (0.0, 0.0)]
    assert simplified(square, 0.05) == square


def test_a_circle_keeps_its_shape_with_far_fewer_points() -> None:
    angles = [0.008 * step for step in range(785)]
    points = [(90 * math.cos(angle), 90 * math.sin(angle)) for angle in angles]
    fewer = simplified(points, 0.05)
    assert len(fewer) < len(points) / 6
    middles = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in pairwise(fewer)]
    assert all(abs(math.hypot(*middle) - 90) < 0.06 for middle in middles)


def test_one_point_or_a_point_twice_stays() -> None:
    assert simplified([(1.0, 1.0)], 0.05) == [(1.0, 1.0)]
    assert simplified([(1.0, 1.0), (1.0, 1.0)], 0.05) == [(1.0, 1.0), (1.0, 1.0)]
