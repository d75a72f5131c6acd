"""The ramp of two motors, as gazebo_ros_diff_drive computes it."""

from __future__ import annotations

import pytest

from simkit.plugins.acceleration import SpeedRamp

STILL = (0.0, 0.0)


def test_without_a_limit_the_targets_are_told_at_once():
    assert SpeedRamp(0.0).next_speeds((5.0, -3.0), STILL, 0.05) == (5.0, -3.0)


def test_no_wheel_is_told_to_accelerate_more_than_the_limit():
    assert SpeedRamp(2.0).next_speeds((1.0, -1.0), STILL, 0.05) == pytest.approx((0.1, -0.1))


def test_it_goes_on_from_what_it_told_and_not_from_what_the_wheels_do():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    assert ramp.next_speeds((1.0, 1.0), STILL, 0.05) == pytest.approx((0.2, 0.2))


def test_the_last_bit_of_the_way_is_as_long_as_what_is_missing():
    assert SpeedRamp(2.0).next_speeds((1.0, 1.0), (0.98, 0.5), 0.05) == pytest.approx((0.02, 0.1))


@pytest.mark.parametrize("measured", [(0.991, 0.0), (0.0, 1.009)])
def test_as_soon_as_one_wheel_is_near_its_target_both_get_theirs(measured):
    assert SpeedRamp(0.1).next_speeds((1.0, 1.0), measured, 0.05) == (1.0, 1.0)


def test_a_wheel_that_has_nothing_to_change_lets_the_other_one_jump():
    assert SpeedRamp(0.1).next_speeds((0.0, 1.0), STILL, 0.05) == (0.0, 1.0)


def test_after_a_jump_the_next_ramp_goes_on_from_the_one_before():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    ramp.next_speeds((1.0, 1.0), (1.0, 1.0), 0.05)
    assert ramp.next_speeds((0.0, 0.0), (1.0, 1.0), 0.05) == pytest.approx((0.0, 0.0))


def test_reset_is_the_beginning():
    ramp = SpeedRamp(2.0)
    ramp.next_speeds((1.0, 1.0), STILL, 0.05)
    ramp.reset()
    assert ramp.next_speeds((1.0, 1.0), STILL, 0.05) == pytest.approx((0.1, 0.1))
