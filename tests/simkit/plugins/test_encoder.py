"""Encoder odometry: what the formula says, and nothing else."""

from __future__ import annotations

import math

import pytest

from simkit.geometry import roll_pitch_yaw
from simkit.plugins.encoder import EncoderOdometry

STEP = 1e-3


def rolled(left: float, right: float, seconds: float, separation: float = 0.4) -> EncoderOdometry:
    """Two wheels whose rims move at these speeds [m/s] for a time."""
    odometry = EncoderOdometry(separation)
    for _ in range(round(seconds / STEP)):
        odometry.advance(left * STEP, right * STEP, STEP)
    return odometry


def test_equal_wheels_go_straight():
    motion = rolled(0.5, 0.5, 2.0).motion
    assert motion.pose.translation == pytest.approx((1.0, 0.0, 0.0), abs=1e-12)
    assert motion.pose.rotation == pytest.approx((0.0, 0.0, 0.0, 1.0), abs=1e-12)
    assert motion.linear == pytest.approx((0.5, 0.0))
    assert motion.turning == 0.0


def test_a_faster_right_wheel_turns_left_on_a_circle():
    left, right, separation = 0.2, 0.4, 0.4
    turning, speed = (right - left) / separation, (left + right) / 2
    motion = rolled(left, right, math.pi / turning, separation).motion
    assert roll_pitch_yaw(motion.pose.rotation)[2] == pytest.approx(math.pi, abs=1e-3)
    assert motion.pose.translation == pytest.approx((0.0, 2 * speed / turning, 0.0), abs=2e-3)
    assert motion.turning == pytest.approx(turning)


def test_opposite_wheels_turn_on_the_spot():
    motion = rolled(-0.2, 0.2, 1.0).motion
    assert motion.pose.translation == (0.0, 0.0, 0.0)
    assert roll_pitch_yaw(motion.pose.rotation)[2] == pytest.approx(1.0)
    assert motion.linear == (0.0, 0.0)


def test_the_speed_is_a_length_also_when_it_goes_backwards():
    motion = rolled(-0.5, -0.5, 1.0).motion
    assert motion.pose.translation[0] == pytest.approx(-0.5)
    assert motion.linear[0] == pytest.approx(0.5)


def test_who_believes_in_wheels_that_are_too_far_apart_believes_to_turn_too_little():
    believed = rolled(-0.15, 0.15, 1.0, separation=0.4).motion
    assert roll_pitch_yaw(believed.pose.rotation)[2] == pytest.approx(0.75)


def test_a_step_is_made_in_the_middle_of_its_turn():
    odometry = EncoderOdometry(1.0)
    odometry.advance(0.0, 1.0, 1.0)
    x, y, _ = odometry.motion.pose.translation
    assert (x, y) == pytest.approx((0.5 * math.cos(0.5), 0.5 * math.sin(0.5)))


def test_reset_is_the_beginning():
    odometry = rolled(0.2, 0.4, 0.5)
    odometry.reset()
    assert odometry.motion == EncoderOdometry(0.4).motion
