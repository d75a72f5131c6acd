"""Limits: where they come from, and what they do to commands."""

from __future__ import annotations

import math

import pytest

from simkit.plugins.control.limits import JointLimits, Limiter, limits_of
from simkit.urdf import Safety, read_robot

FREE = {"position": 0.0, "period_s": 0.1}


def joint(kind, inside=""):
    robot = read_robot(
        f'<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="{kind}">'
        f'<parent link="a"/><child link="b"/>{inside}</joint></robot>',
        file="r",
    ).robot
    return robot.joints["j"]


LIMIT = '<limit lower="-1" upper="2" effort="30" velocity="4"/>'


def test_a_joint_has_the_limits_of_the_urdf():
    assert limits_of(joint("revolute", LIMIT), {}) == JointLimits(
        lower=-1.0, upper=2.0, effort=30.0, velocity=4.0
    )


def test_a_joint_that_turns_has_no_ends():
    limits = limits_of(joint("continuous", LIMIT), {})
    assert (limits.lower, limits.upper, limits.effort) == (-math.inf, math.inf, 30.0)


def test_a_joint_without_limits_has_none():
    assert limits_of(joint("continuous"), {}) is None
    assert limits_of(None, {}) is None


def test_parameters_override_the_urdf():
    given = {
        "has_position_limits": True,
        "min_position": -0.5,
        "max_position": 0.5,
        "has_velocity_limits": False,
        "has_effort_limits": True,
        "max_effort": 7,
        "has_acceleration_limits": True,
        "max_acceleration": 3.0,
    }
    limits = limits_of(joint("revolute", LIMIT), given)
    assert limits == JointLimits(lower=-0.5, upper=0.5, effort=7.0, acceleration=3.0)
    assert limits_of(None, {"has_effort_limits": True, "max_effort": 1.0}) == JointLimits(
        effort=1.0
    )
    assert limits_of(joint("revolute", LIMIT), {"has_position_limits": False}).upper == math.inf


def test_a_parameter_that_is_no_number_changes_nothing():
    given = {"has_effort_limits": True, "max_effort": "strong", "has_position_limits": True}
    found = limits_of(joint("revolute", LIMIT), {**given, "min_position": 0, "max_position": None})
    assert found == limits_of(joint("revolute", LIMIT), {})


def test_a_position_is_reached_no_faster_than_the_limit_says():
    limiter = Limiter(JointLimits(lower=-1.0, upper=0.3, velocity=2.0))
    found = [limiter.position(5.0, position=0.0, period_s=0.1) for _ in range(3)]
    assert found == pytest.approx([0.2, 0.3, 0.3])
    assert limiter.position(-5.0, position=0.0, period_s=0.1) == pytest.approx(0.1)


def test_a_velocity_is_within_its_limit_and_changes_no_faster_than_it_may():
    limiter = Limiter(JointLimits(velocity=2.0, acceleration=5.0))
    found = [limiter.velocity(9.0, **FREE) for _ in range(5)]
    assert found == pytest.approx([0.5, 1.0, 1.5, 2.0, 2.0])
    assert Limiter(JointLimits(velocity=2.0)).velocity(-9.0, **FREE) == -2.0


@pytest.mark.parametrize(
    ("position", "velocity", "pushed", "pulled"),
    [
        (0.0, 0.0, 10.0, -10.0),
        (1.5, 0.0, 0.0, -10.0),
        (-1.5, 0.0, 10.0, 0.0),
        (0.0, 3.0, 0.0, -10.0),
    ],
)
def test_no_effort_drives_a_joint_on_beyond_a_limit(position, velocity, pushed, pulled):
    limiter = Limiter(JointLimits(lower=-1.0, upper=1.0, velocity=2.0, effort=10.0))
    state = {"position": position, "velocity": velocity}
    assert (limiter.effort(99.0, **state), limiter.effort(-99.0, **state)) == (pushed, pulled)


def test_near_a_soft_limit_a_joint_slows_down():
    soft = Safety(soft_lower=-0.8, soft_upper=0.8, k_position=10.0, k_velocity=5.0)
    limits = JointLimits(lower=-1.0, upper=1.0, velocity=2.0, effort=10.0, soft=soft)
    assert Limiter(limits).velocity(9.0, position=0.7, period_s=0.1) == pytest.approx(1.0)
    assert Limiter(limits).velocity(9.0, position=0.9, period_s=0.1) == pytest.approx(-1.0)
    assert Limiter(limits).position(5.0, position=0.7, period_s=0.1) == pytest.approx(0.8)
    assert Limiter(limits).effort(9.0, position=0.8, velocity=0.5) == pytest.approx(-2.5)
    assert Limiter(limits).effort(9.0, position=0.0, velocity=0.0) == pytest.approx(9.0)
