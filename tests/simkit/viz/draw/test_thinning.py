from __future__ import annotations

import math
from itertools import accumulate, pairwise

from hypothesis import given
from hypothesis import strategies as st

from simkit.viz.draw.thinning import simplified, thinned

STEPS = st.lists(
    st.tuples(st.sampled_from([0.0, 0.016, 0.016, 1.0]), st.floats(-5, 5), st.floats(-5, 5)),
    min_size=1,
    max_size=60,
)


def value_at(rows, time):
    """All values that a way through the rows has at a time."""
    found = []
    for before, after in pairwise(rows):
        if before[0] <= time <= after[0]:
            ratio = (time - before[0]) / (after[0] - before[0]) if after[0] > before[0] else 0.0
            found.append([a + ratio * (b - a) for a, b in zip(before[1:], after[1:], strict=True)])
            found.append(list(after[1:]) if after[0] == time else found[-1])
    return found or [list(rows[0][1:])]


@given(STEPS)
def test_interpolation_gives_back_every_row(steps):
    rows = list(accumulate(steps, lambda a, b: (a[0] + b[0], *b[1:])))
    kept = thinned(rows, (0.1, 0.5))
    assert kept[0] == rows[0]
    assert kept[-1] == rows[-1]
    remaining = iter(rows)
    assert all(row in remaining for row in kept)
    for row in rows:
        errors = [
            max(abs(a - b) / t for a, b, t in zip(row[1:], values, (0.1, 0.5), strict=True))
            for values in value_at(kept, row[0])
        ]
        assert min(errors) <= 1.0 + 1e-9


def test_a_steady_motion_is_two_rows():
    rows = [(0.016 * k, 2.0 * k) for k in range(1000)]
    assert thinned(rows, (0.1,)) == [rows[0], rows[-1]]


def test_a_jump_is_kept():
    rows = [(0.0, 1.0), (1.0, 1.0), (1.0, 9.0), (2.0, 9.0)]
    assert thinned(rows, (0.1,)) == rows


def test_few_rows_stay():
    assert thinned([], (0.1,)) == []
    assert thinned([(0.0, 1.0)], (0.1,)) == [(0.0, 1.0)]


def test_a_straight_run_becomes_its_two_ends():
    points = [(0.72 * step, 0.36 * step) for step in range(1000)]
    assert simplified(points, 0.05) == [points[0], points[-1]]


def test_turning_round_on_the_spot_keeps_the_turning_point():
    points = [(float(x), 0.0) for x in [*range(10), *range(9, 3, -1)]]
    assert simplified(points, 0.05) == [(0.0, 0.0), (9.0, 0.0), (4.0, 0.0)]


def test_a_closed_way_is_kept():
    square = [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0), (0.0, 0.0)]
    assert simplified(square, 0.05) == square


def test_a_circle_keeps_its_shape_with_far_fewer_points():
    angles = [0.008 * step for step in range(785)]
    points = [(90 * math.cos(angle), 90 * math.sin(angle)) for angle in angles]
    fewer = simplified(points, 0.05)
    assert len(fewer) < len(points) / 6
    middles = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in pairwise(fewer)]
    assert all(abs(math.hypot(*middle) - 90) < 0.06 for middle in middles)


def test_one_point_or_a_point_twice_stays():
    assert simplified([(1.0, 1.0)], 0.05) == [(1.0, 1.0)]
    assert simplified([(1.0, 1.0), (1.0, 1.0)], 0.05) == [(1.0, 1.0), (1.0, 1.0)]
