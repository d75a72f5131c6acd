"""Motions of one joint: the numbers of the original's splines, rest before and after, and which segment counts."""

from __future__ import annotations

import numpy as np
import pytest

from simkit.plugins.control.trajectory.segment import (
    Knot,
    State,
    find_segment,
    sample,
    segment_between,
    spline_between,
)

SECOND = 1_000_000_000


def line(start_s, begin, end_s, end):
    return segment_between(
        start_s * SECOND, Knot(position=begin), end_s * SECOND, Knot(position=end)
    )


def test_a_joint_rests_before_a_segment_and_after_it():
    segment = line(1, 2.0, 3, 4.0)
    assert segment.sample(0) == State(2.0)
    assert segment.sample(2 * SECOND) == State(3.0, 1.0)
    assert segment.sample(3 * SECOND) == State(4.0, 1.0)
    assert segment.sample(3 * SECOND + 1) == State(4.0)


def test_the_end_is_exact():
    segment = line(0, 0.1, 3, 0.7)
    assert segment.sample(3 * SECOND).position == 0.7
    assert segment.sample(4 * SECOND).position == 0.7


def test_the_last_segment_that_has_begun_counts():
    trajectory = (line(0, 0.0, 1, 1.0), line(1, 1.0, 2, 0.0), line(5, 3.0, 6, 4.0))
    found = [find_segment(trajectory, t * SECOND) for t in (-1, 0, 1, 4, 5, 9)]
    assert found == [-1, 0, 1, 1, 2, 2]
    assert sample(trajectory, 4 * SECOND) == State(0.0)
    assert sample(trajectory, -SECOND) == State(0.0)
    assert sample(trajectory, 9 * SECOND) == State(4.0)


def test_of_segments_that_begin_together_the_last_one_counts():
    trajectory = (line(0, 0.0, 1, 1.0), line(0, 5.0, 1, 6.0))
    assert find_segment(trajectory, 0) == 1


def test_a_segment_without_time_holds_its_beginning():
    segment = line(1, 2.0, 1, 4.0)
    assert {segment.sample(t).position for t in (0, SECOND, 2 * SECOND)} == {2.0}


def near(value):
    return pytest.approx(value, abs=1e-12)


@pytest.mark.parametrize(
    ("time", "position", "velocity"),
    [
        (0.0, 0.0, 0.0),
        (0.5, 0.15625, 0.5625),
        (1.0, 0.5, 0.75),
        (1.5, 0.84375, 0.5625),
        (2.0, 1.0, 0.0),
    ],
)
def test_a_cubic_from_rest_to_rest(time, position, velocity):
    spline = spline_between(Knot(position=0.0, velocity=0.0), Knot(position=1.0, velocity=0.0), 2.0)
    state = spline.at(time)
    assert (state.position, state.velocity) == (near(position), near(velocity))


@pytest.mark.parametrize(
    ("time", "position", "velocity"),
    [
        (0.5, 0.103515625, 0.52734375),
        (1.0, 0.5, 0.9375),
        (1.5, 0.896484375, 0.52734375),
        (2.0, 1.0, 0.0),
    ],
)
def test_a_quintic_from_rest_to_rest(time, position, velocity):
    rest = {"velocity": 0.0, "acceleration": 0.0}
    spline = spline_between(Knot(position=0.0, **rest), Knot(position=1.0, **rest), 2.0)
    state = spline.at(time)
    assert (state.position, state.velocity) == (near(position), near(velocity))


def test_a_cubic_that_turns_back():
    spline = spline_between(
        Knot(position=0.0, velocity=1.0), Knot(position=1.0, velocity=-1.0), 2.0
    )
    assert spline.at(0.5).position == near(0.53125)
    assert spline.at(1.0).position == near(1.0)


def test_positions_alone_give_a_straight_line():
    spline = spline_between(Knot(position=1.0, velocity=7.0), Knot(position=3.0), 4.0)
    assert [spline.at(t).position for t in (0.0, 1.0, 4.0)] == [1.0, 1.5, 3.0]
    assert {spline.at(t).velocity for t in (0.0, 1.0, 4.0)} == {0.5}
    assert spline.at(2.0).acceleration == 0.0


def test_what_only_one_end_says_does_not_count():
    full = Knot(position=0.0, velocity=1.0, acceleration=2.0)
    orders = [
        len(spline_between(full, end, 1.0).coefficients) - 1
        for end in (
            Knot(position=1.0),
            Knot(position=1.0, acceleration=0.0),
            Knot(position=1.0, velocity=0.0),
            Knot(position=1.0, velocity=0.0, acceleration=0.0),
        )
    ]
    assert orders == [1, 1, 3, 5]


def test_without_time_it_stays_as_it_begins():
    start = Knot(position=2.0, velocity=3.0, acceleration=4.0)
    end = Knot(position=9.0, velocity=0.0, acceleration=0.0)
    state = spline_between(start, end, 0.0).at(0.0)
    assert (state.position, state.velocity, state.acceleration) == (2.0, 3.0, 4.0)


def test_a_spline_has_what_its_ends_say():
    rng = np.random.default_rng(2)
    for p0, v0, a0, p1, v1, a1 in rng.uniform(-3.0, 3.0, (100, 6)).tolist():
        duration = float(rng.uniform(0.5, 3.0))
        start = Knot(position=p0, velocity=v0, acceleration=a0)
        end = Knot(position=p1, velocity=v1, acceleration=a1)
        quintic = spline_between(start, end, duration)
        for state, knot in ((quintic.at(0.0), start), (quintic.at(duration), end)):
            assert state.position == pytest.approx(knot.position, abs=1e-10)
            assert state.velocity == pytest.approx(knot.velocity, abs=1e-9)
            assert state.acceleration == pytest.approx(knot.acceleration, abs=1e-8)
        cubic = spline_between(
            Knot(position=p0, velocity=v0), Knot(position=p1, velocity=v1), duration
        )
        assert cubic.at(duration).position == pytest.approx(p1, abs=1e-10)
        assert cubic.at(duration).velocity == pytest.approx(v1, abs=1e-9)


def test_velocity_and_acceleration_are_the_derivatives():
    start = Knot(position=0.3, velocity=-1.0, acceleration=2.0)
    spline = spline_between(start, Knot(position=1.0, velocity=0.5, acceleration=-1.0), 1.7)
    step = 1e-5
    for time in (0.2, 0.9, 1.5):
        before, here, after = (spline.at(time + d) for d in (-step, 0.0, step))
        assert (after.position - before.position) / (2 * step) == pytest.approx(
            here.velocity, abs=1e-8
        )
        assert (after.velocity - before.velocity) / (2 * step) == pytest.approx(
            here.acceleration, abs=1e-8
        )
