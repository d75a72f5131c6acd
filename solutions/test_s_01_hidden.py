"""Exercise S.1, hidden checks: a curve, and the odometry along it."""

import math

import pytest

from grader.checks import after, expect, expect_close, expect_close_angle, points
from grader.checks.robots import RobotFiles
from oracles.driven_robot import DrivenRobot, Stand, heading_of

ROBOT = "m2wr.urdf"
WHEELS = ("link_left_wheel", "link_right_wheel")


@pytest.fixture
def robot(sim, exercise, submission, package_path):
    """The student's robot on the floor of an empty world."""
    robots = RobotFiles(exercise, submission, package_path)
    return DrivenRobot(sim, robots.robot(ROBOT), robots.text(ROBOT), name="m2wr")


@points(1)
@after("test_it_drives_straight_on", "test_left_is_left")
def test_odometry_follows_a_curve(sim, robot):
    """On a curve to the right the robot turns as commanded, and /odom and tf report where it went."""
    sim.run(0.2)
    begun = _odometry(sim)
    start, axle = robot.stand, robot.axle(*WHEELS)
    moved = robot.drive(0.3, -0.5, settle=0.5, seconds=1.5)
    expect_close_angle(
        moved.heading,
        -0.75,
        tolerance=0.03,
        what="how far it turned in 1.5 s at -0.5 rad/s",
        hint="The robot drives and turns at once. Does one of its wheels slip? Is <wheelSeparation> the distance between them?",
    )
    robot.command(0.0, 0.0)
    sim.run(0.3)
    told = _odometry(sim).seen_from(begun)
    # What the wheels rolled is the way of their middle, which odometry then takes for that of the robot.
    ways = (robot.stand.seen_from(start), robot.axle(*WHEELS).seen_from(axle))
    there = min(ways, key=lambda way: math.dist(way[:2], told[:2]))
    expect_close(
        (told.x, told.y),
        (there.x, there.y),
        tolerance=0.05,
        what="how far the robot came ahead and to the left, according to /odom",
        unit="m",
        hint="Odometry from the wheels is computed with <wheelDiameter> and <wheelSeparation>.",
    )
    expect_close_angle(
        told.heading,
        there.heading,
        tolerance=math.radians(8),
        what="how far the robot turned, according to /odom",
        hint="Odometry from the wheels is computed with <wheelSeparation>.",
    )
    frame = sim.latest("/odom").child_frame_id
    expect(
        sim.tf.can_transform("odom", frame),
        f"tf does not know {frame}, seen from odom",
        hint="<odometryFrame> and <robotBaseFrame> set which frames the plugin broadcasts, and <publishTf> whether it does.",
    )


def _odometry(sim):
    """Where the robot is, according to /odom."""
    pose = sim.wait_for_message("/odom", 1.0).pose.pose
    q = pose.orientation
    return Stand(pose.position.x, pose.position.y, heading_of((q.x, q.y, q.z, q.w)))
