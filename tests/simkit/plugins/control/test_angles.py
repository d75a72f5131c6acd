"""Angles: short ways, limits, whole turns."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.plugins.control.angles import (
    TURN,
    ContinuousAngle,
    distance_within_limits,
    shortest_angular_distance,
    wraparound_offset,
)


@pytest.mark.parametrize(
    ("start", "end", "way"),
    [
        (0.0, 1.0, 1.0),
        (3.0, -3.0, TURN - 6.0),
        (0.0, math.pi, math.pi),
        (math.pi, 0.0, math.pi),  # half a turn is always the positive one
        (0.0, 4.5 * math.pi, 0.5 * math.pi),
        (0.25 * math.pi, 4.5 * math.pi, 0.25 * math.pi),
    ],
)
def test_the_short_way_is_at_most_half_a_turn(start, end, way):
    assert shortest_angular_distance(start, end) == pytest.approx(way, abs=1e-12)


def test_the_short_way_leads_there_up_to_whole_turns():
    rng = np.random.default_rng(1)
    for start, end in rng.uniform(-20.0, 20.0, (200, 2)).tolist():
        way = shortest_angular_distance(start, end)
        assert -math.pi < way <= math.pi
        assert math.cos(start + way - end) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize(
    ("start", "end", "lower", "upper", "way"),
    [
        (-3.0, 3.0, -3.1, 3.1, 6.0),  # the short way would leave the limits
        (-3.0, 3.0, -math.pi, 6.0, 6.0),
        (0.5, 1.0, 0.0, 2.0, 0.5),
        (0.5, 5.0, 0.0, 2.0, 4.5),  # no such angle is within the limits
        (5.0, 0.5, -7.0, 7.0, 1.5 - 6.0 + TURN),
        (3.0, -3.0, -math.inf, math.inf, TURN - 6.0),
        (3.0, -3.0, -1e300, 1e300, TURN - 6.0),
    ],
)
def test_the_way_of_a_joint_with_limits_stays_within_them(start, end, lower, upper, way):
    assert distance_within_limits(start, end, lower, upper) == pytest.approx(way, abs=1e-12)


@pytest.mark.parametrize(
    ("start", "end", "turns"),
    [
        (0.25 * math.pi, 4.5 * math.pi, -2),
        (0.5 * math.pi, -1.75 * math.pi, 1),
        (-0.5 * math.pi, 0.5 * math.pi, 0),  # half a turn: nothing is added
        (0.5 * math.pi, -0.5 * math.pi, 0),
        (0.1, 0.4, 0),
    ],
)
def test_the_offset_is_a_number_of_whole_turns(start, end, turns):
    assert wraparound_offset(start, end) == turns * TURN


def test_a_continuous_angle_begins_within_half_a_turn_of_one():
    assert ContinuousAngle().read(0.0) == 0.0
    assert ContinuousAngle().read(-3.0) == pytest.approx(TURN - 3.0)
    assert ContinuousAngle().read(5.0) == pytest.approx(5.0 - TURN)


def test_a_continuous_angle_takes_the_short_way_when_it_is_put_somewhere():
    angle = ContinuousAngle()
    angle.read(0.0)
    assert angle.read(10.0) == pytest.approx(10.0 - 2.0 * TURN)
    assert angle.read(10.5) == pytest.approx(10.5 - 2.0 * TURN)
    assert angle.read(0.0) == pytest.approx(0.0, abs=1e-12)


def test_a_continuous_angle_counts_turns_as_the_joint_does():
    angle = ContinuousAngle()
    for number in range(1000):
        assert angle.read(0.1 * number) == 0.1 * number
