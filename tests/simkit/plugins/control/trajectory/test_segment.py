"""Segments: rest before and after, and which one counts."""

from __future__ import annotations

from simkit.plugins.control.trajectory.segment import (
    find_segment,
    sample,
    segment_between,
)
from simkit.plugins.control.trajectory.spline import Knot, State

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
