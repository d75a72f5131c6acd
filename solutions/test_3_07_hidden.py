"""Exercise 3.7, hidden checks: full turns, and the base as it was."""

import math

import pytest

from grader.checks import after, expect_close, points
from grader.checks.robots import RobotFiles
from grader.checks.rotations import about_z, apart, times
from oracles.moved_robot import MovedRobot

ROBOT = "hello_ros_robot_2.urdf"


@pytest.fixture
def moved(sim, exercise, submission, package_path):
    """The student's robot on the graph."""
    robots = RobotFiles(exercise, submission, package_path)
    return MovedRobot(sim, robots.robot(ROBOT), robots.text(ROBOT))


@points(1)
@after("test_the_hip_turns_about_z")
def test_it_turns_all_the_way_round(moved, rng):
    """After several whole turns and a bit, the torso is oriented as after the bit alone, and the base never moves."""
    moved.move(hip=0.0)
    _, straight = moved.pose("torso")
    base = moved.pose("base_link")
    for turns in (-2, 3):
        bit = rng.uniform(-3.0, 3.0)
        moved.move(hip=turns * math.tau + bit)
        _, turned = moved.pose("torso")
        expect_close(
            apart(turned, times(about_z(bit), straight)),
            0.0,
            tolerance=1e-4,
            what=f"the difference from a rotation by {bit:.2f} rad, after {abs(turns)} whole turns",
            unit="rad",
        )
    expect_close(
        moved.pose("base_link")[0],
        base[0],
        tolerance=1e-9,
        what="the position of base_link",
        unit="m",
    )
    lower, upper = sorted(moved.ends("base_link"), key=lambda end: end[2])
    expect_close(
        (lower[2], upper[2]),
        (0.0, 0.05),
        tolerance=1e-4,
        what="the heights of the base's lower and upper end",
        unit="m",
        hint="The base must be the one of the example: 0.05 m high, and standing on the ground.",
    )
