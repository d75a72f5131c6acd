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
    """From another angle, let go, hip and shoulder are where the equations of motion say 0.4 s later."""
    hip, shoulder = rng.uniform(-2.0, 2.0), rng.uniform(-0.8, 0.8)
    arm.set_joint_positions({"hip": hip, "shoulder": shoulder})
    sim.run(0.4)
    expect_close(
        (arm.joint("hip").position, arm.joint("shoulder").position),
        SwingingArm().swing(hip, shoulder, 0.4),
        tolerance=0.02,
        what=f"hip and shoulder, 0.4 s after they were let go at {hip:.2f} and {shoulder:.2f} rad",
        unit="rad",
        hint="Nothing but weight acts on the arm, and nothing stops it.",
    )


@points(1)
@after("test_the_arm_swings_as_it_must")
def test_it_keeps_its_energy(sim, arm):
    """Nothing rubs: after a second of swinging the arm has the energy that it had."""
    fall = 1.96  # what it can gain: m g l
    before = arm.kinetic_energy + arm.potential_energy
    sim.run(1.0)
    expect_close(
        arm.kinetic_energy + arm.potential_energy - before,
        0.0,
        tolerance=0.01 * fall,
        what="what the arm gained of energy within a second",
        unit="J",
        hint="Damping and friction, in <dynamics>, eat energy. This arm has none.",
    )
