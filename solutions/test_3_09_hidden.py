"""Exercise 3.9, hidden checks: other starts, and energy."""

import pytest

from grader.checks import after, expect_close, points
from grader.checks.robots import RobotFiles
from oracles.swinging_arm import SwingingArm

ROBOT = "hello_gazebo_robot_1.urdf"


@pytest.fixture
def arm(sim, exercise, submission, package_path):
    """The student's robot in an empty world."""
    robots = RobotFiles(exercise, submission, package_path)
    robots.robot(ROBOT)
    return sim.gazebo.spawn_urdf(robots.text(ROBOT), name="arm", file=ROBOT).model


@points(1)
@after("test_the_arm_swings_as_it_must")
def test_it_swings_from_anywhere(sim, arm, rng):
    """Released at another angle, hip and shoulder are where the equations of motion put them 0.4 s later."""
    hip, shoulder = rng.uniform(-2.0, 2.0), rng.uniform(-0.8, 0.8)
    arm.set_joint_positions({"hip": hip, "shoulder": shoulder})
    sim.run(0.4)
    expect_close(
        (arm.joint("hip").position, arm.joint("shoulder").position),
        SwingingArm().swing(hip, shoulder, 0.4),
        tolerance=0.02,
        what=f"hip and shoulder, 0.4 s after their release at {hip:.2f} and {shoulder:.2f} rad",
        unit="rad",
        hint="Only gravity may act on the arm: no damping, no friction, no limit.",
    )


@points(1)
@after("test_the_arm_swings_as_it_must")
def test_it_keeps_its_energy(sim, arm):
    """There is no friction: after a second of swinging the arm has the same energy as before."""
    fall = 1.96  # what it can gain: m g l
    before = arm.kinetic_energy + arm.potential_energy
    sim.run(1.0)
    expect_close(
        arm.kinetic_energy + arm.potential_energy - before,
        0.0,
        tolerance=0.01 * fall,
        what="the change of the arm's energy within a second",
        unit="J",
        hint="Damping and friction in <dynamics> take energy out. This arm should have neither.",
    )
