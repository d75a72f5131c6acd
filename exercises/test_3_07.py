"""Exercise 3.7, public checks: a torso on a hip that turns, and the nodes that make frames of it."""

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.robots import (
    RobotFiles,
    expect_chain,
    expect_firm,
    expect_silver_cylinder,
    joints_above,
    slider_of,
)
from grader.checks.rotations import about_z, apart, times
from grader.errors import CheckFailed
from oracles.moved_robot import MovedRobot, SeenRobot, expect_to_follow, require_joint
from simkit.diagnostics import Severity
from simkit.errors import SimkitError
from simkit.urdf import JointType

ROBOT = "hello_ros_robot_2.urdf"
LAUNCH = "urdf_launch_2.launch"


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def moved(sim, robots):
    """The student's robot on the graph."""
    return MovedRobot(sim, robots.robot(ROBOT), robots.text(ROBOT))


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """ROS accepts hello_ros_robot_2.urdf: torso is attached to base_link, and base_link is fixed to world."""
    robots.expect_clean(ROBOT, severity=Severity.ERROR)
    robot = robots.robot(ROBOT)
    expect_chain(robot, "world", "base_link", "torso")
    expect_firm(robot, "base_link")


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_check_urdf_finds_nothing_wrong(robots):
    """check_urdf has no warning about hello_ros_robot_2.urdf either."""
    robots.expect_clean(ROBOT)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_torso_has_its_shape(robots):
    """The torso is a silver cylinder, 0.5 m long, with a radius of 0.05 m."""
    expect_silver_cylinder(robots.robot(ROBOT), "torso", length=0.5, radius=0.05)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_torso_stands_on_the_base(moved):
    """The torso stands upright on the base: its lower end at height 0.05 m, its upper at 0.55 m."""
    moved.move(hip=0.0)
    ends = sorted(moved.ends("torso"), key=lambda end: end[2])
    for end, height, which in zip(ends, (0.05, 0.55), ("lower", "upper"), strict=True):
        expect_close(
            end,
            (0.0, 0.0, height),
            tolerance=1e-4,
            what=f"the {which} end of the torso",
            unit="m",
            frame="world",
            hint="The hip is on top of the base, and the middle of the torso is half its length above the hip.",
        )


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_hip_turns_about_z(robots, moved, rng):
    """With the hip at an angle, the torso is rotated by that angle about the vertical axis, to the left."""
    require_joint(robots.robot(ROBOT), "hip")
    moved.move(hip=0.0)
    place, straight = moved.pose("torso")
    for _ in range(3):
        angle = rng.uniform(-1.5, 1.5)
        moved.move(hip=angle)
        new_place, turned = moved.pose("torso")
        hint = (
            "The hip turns about its <axis>, and z points up. "
            "Without <axis> it is the x axis; with a minus sign the torso turns the other way."
        )
        expect_close(
            apart(turned, times(about_z(angle), straight)),
            0.0,
            tolerance=1e-4,
            what=f"the difference from a rotation by {angle:.2f} rad about z",
            unit="rad",
            hint=hint,
        )
        expect_close(
            new_place,
            place,
            tolerance=1e-4,
            what=f"the position of torso after a rotation by {angle:.2f} rad",
            unit="m",
            frame="world",
            hint="The frame of torso is on the axis, so x and y of the hip's origin are 0.",
        )


@points(2)
@after("test_check_urdf_takes_your_robot")
def test_the_launch_file_brings_the_frames(sim, roslaunch, robots):
    """After the launch tf knows world, base_link and torso, and a slider turns the torso."""
    launched = roslaunch(LAUNCH)
    expect(
        sim.run_until(lambda: sim.tf.can_transform("world", "torso"), 2.0),
        "2 s after the launch tf does not know torso, seen from world",
        hint="robot_state_publisher computes the frames, from robot_description and from the angles that "
        "joint_state_publisher publishes on /joint_states. Do both run? " + what_is_there(sim),
    )
    slider = slider_of(launched)
    expect(
        "hip" in [joint.name for joint in slider.joints],
        "there is no slider for the hip",
        hint="There is a slider for each joint in robot_description that can move.",
    )
    slider.set_position("hip", 0.5)
    sim.run(0.3)
    expect_to_follow(SeenRobot(sim, robots.robot(ROBOT)), robots.text(ROBOT), "torso", hip=0.5)


def what_is_there(sim):
    """The nodes that run, and the parameters, as two sentences."""
    nodes = [name for name in sim.nodes() if name != "/simkit"]
    return (
        f"Nodes that run: {', '.join(nodes) or 'none'}. "
        f"Parameters: {', '.join(sim.params.names()[:5]) or 'none'}."
    )


@points(1)
def test_your_answers(robots, launch_plan, submission):
    """The answers name the parent of torso, the frame that never moves, the broadcaster, and the rate."""
    own = own_names(robots, launch_plan)
    for name, right, hint in (
        (
            "parent_of_torso",
            "base_link",
            "In the drawing each arrow leads from the parent to the child.",
        ),
        (
            "never_moves",
            "base_link",
            "It is the child of the joint of type fixed.",
        ),
        (
            "broadcaster",
            "robot_state_publisher",
            "The drawing names the broadcaster beside each arrow. The other node publishes only the angles.",
        ),
    ):
        told = set(words_of(given_answer(submission, name))) - {"the", "frame", "link", "node"}
        expect(
            len(told) == 1 and told <= {right, *own.get(name, ())},
            f"{name} is not right",
            hint=hint,
        )
    told = given_answer(submission, "torso_rate")
    expect(
        isinstance(told, int | float) and abs(told - 10.0) < 0.6,
        "torso_rate is not right",
        hint="The drawing shows the average rate of each transform; 10000 is what it prints for static ones. Write a "
        "number, without quotes.",
    )


def own_names(robots, launch_plan):
    """What is right as well, since the student's own robot and nodes are called so."""
    try:
        robot, plan = robots.robot(ROBOT), launch_plan(LAUNCH)
    except (CheckFailed, SimkitError):
        return {}
    return {
        "parent_of_torso": [joint.parent for joint in joints_above(robot, "torso")[:1]],
        "never_moves": [joint.child for joint in robot.joints.values() if not joint.moves],
        "broadcaster": [
            node.name for node in plan.nodes if node.package == "robot_state_publisher"
        ],
    }


@points(1)
@after("test_the_hip_turns_about_z")
def test_the_hip_has_no_end(robots):
    """The hip turns without limits."""
    hip = robots.robot(ROBOT).joints["hip"]
    expect(
        hip.type is JointType.CONTINUOUS,
        f"the hip is {hip.type.value}: it stops at its limits",
        hint='A joint that turns without limits has type="continuous".',
    )
