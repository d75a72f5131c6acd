"""Exercise 3.8, hidden checks: the whole range of both joints."""

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.robots import RobotFiles
from oracles.moved_robot import MovedRobot
from simkit.urdf import JointType

ROBOT = "hello_ros_robot_3.urdf"


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@points(1)
@after("test_the_joints_carry_the_arm")
def test_nothing_stops_the_joints(sim, robots):
    """Both joints turn without limits, and the torso stays upright under the arm."""
    robot = robots.robot(ROBOT)
    for name in ("hip", "shoulder"):
        kind = robot.joints[name].type
        expect(
            kind is JointType.CONTINUOUS,
            f"the joint {name} is {kind.value}: it stops at its limits",
            hint='A joint that turns without limits has type="continuous".',
        )
    moved = MovedRobot(sim, robot, robots.text(ROBOT))
    moved.move(hip=4.0, shoulder=-4.0)
    lower, upper = sorted(moved.ends("torso"), key=lambda end: end[2])
    expect_close(
        (*lower, *upper),
        (0.0, 0.0, 0.05, 0.0, 0.0, 0.55),
        tolerance=1e-3,
        what="the lower and the upper end of the torso",
        unit="m",
        frame="world",
        hint="The torso must be the one of exercise 3.7: 0.5 m long, and standing on the base.",
    )
