"""Exercise 3.8, public checks: an arm with two joints, and where its tip is."""

import math

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer
from grader.checks.personal import name_of, pose_of
from grader.checks.robots import (
    RobotFiles,
    expect_chain,
    expect_firm,
    expect_silver_cylinder,
    slider_of,
)
from oracles.moved_robot import MovedRobot, SeenRobot, expect_to_follow, require_joint
from simkit.diagnostics import Severity

ROBOT = "hello_ros_robot_3.urdf"
LAUNCH = "urdf_launch_3.launch"
WAYS = (("backward", "forward"), ("to the right", "to the left"), ("down", "up"))


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def moved(sim, robots):
    """The student's robot on the graph, with both its joints."""
    robot = robots.robot(ROBOT)
    for joint in ("hip", "shoulder"):
        require_joint(robot, joint)
    return MovedRobot(sim, robot, robots.text(ROBOT))


def arm_at(hip, shoulder):
    """Where the shoulder's end and the tip of the arm are in the world [m], by the formula."""

    def turned(x, y, z):
        return (math.cos(hip) * x - math.sin(hip) * y, math.sin(hip) * x + math.cos(hip) * y, z)

    reach, rise = 0.4 * math.cos(shoulder), -0.4 * math.sin(shoulder)
    return turned(0.0, -0.1, 0.5), turned(reach, -0.1, 0.5 + rise)


def expect_the_arm(moved, *, hip, shoulder, hint):
    """At these angles the two ends of the upper arm are where the formula says."""
    moved.move(hip=hip, shoulder=shoulder)
    near, tip = arm_at(hip, shoulder)
    ends = sorted(moved.ends("upper_arm"), key=lambda end: math.dist(end, near))
    where = f"with the hip at {hip:.2f} and the shoulder at {shoulder:.2f} rad"
    for end, place, what in ((ends[0], near, "the shoulder's end"), (ends[1], tip, "the tip")):
        expect_close(
            end,
            place,
            tolerance=1e-3,
            what=f"{what} of the upper arm, {where}",
            unit="m",
            frame="world",
            hint=hint,
        )


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """ROS accepts hello_ros_robot_3.urdf: a chain from world to upper_arm, on a base that is fixed."""
    robots.expect_clean(ROBOT, severity=Severity.ERROR)
    robot = robots.robot(ROBOT)
    expect_chain(robot, "world", "base_link", "torso", "upper_arm")
    expect_firm(robot, "base_link")


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_check_urdf_finds_nothing_wrong(robots):
    """check_urdf has no warning about hello_ros_robot_3.urdf either."""
    robots.expect_clean(ROBOT)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_upper_arm_has_its_shape(robots):
    """The upper arm is a silver cylinder, 0.4 m long, with a radius of 0.05 m."""
    expect_silver_cylinder(robots.robot(ROBOT), "upper_arm", length=0.4, radius=0.05)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_at_zero_the_arm_points_forward(moved):
    """With both joints at 0 the arm points forward, parallel to the ground, from the shoulder beside the torso."""
    moved.move(hip=0.0, shoulder=0.0)
    expect_the_arm(
        moved,
        hip=0.0,
        shoulder=0.0,
        hint=f"Your arm points {pointing(*moved.ends('upper_arm'))}. The origin of the shoulder is 0 -0.1 0.45 in the "
        "frame of the torso, with rpy 0 1.5708 0, so that the arm points forward. The middle of the arm is half its "
        "length along the z axis of its own frame.",
    )


def pointing(one, other):
    """In words, the direction of an arm with these ends; the end nearer to the shoulder is its beginning."""
    near, far = sorted((one, other), key=lambda end: math.dist(end, arm_at(0.0, 0.0)[0]))
    along = [b - a for a, b in zip(near, far, strict=True)]
    axis = max(range(3), key=lambda number: abs(along[number]))
    return WAYS[axis][along[axis] > 0]


@points(2)
@after("test_at_zero_the_arm_points_forward")
def test_the_joints_carry_the_arm(moved, rng):
    """For random angles of hip and shoulder, both ends of the arm are where forward kinematics says."""
    expect_the_arm(
        moved,
        hip=0.0,
        shoulder=rng.uniform(0.3, 1.2),
        hint="The shoulder turns about its y axis, and a positive angle lowers the arm.",
    )
    expect_the_arm(
        moved,
        hip=rng.uniform(0.3, 1.2),
        shoulder=0.0,
        hint="The hip turns the torso about z, and the torso carries the arm.",
    )
    expect_the_arm(
        moved,
        hip=rng.uniform(-3.0, 3.0),
        shoulder=rng.uniform(-3.0, 3.0),
        hint="Each joint turns about its own axis: the hip about z, the shoulder about y.",
    )


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_launch_file_brings_two_sliders(sim, roslaunch, robots):
    """After the launch tf knows upper_arm, and two sliders move the arm."""
    launched = roslaunch(LAUNCH)
    nodes = [name for name in sim.nodes() if name != "/simkit"]
    expect(
        sim.run_until(lambda: sim.tf.can_transform("world", "upper_arm"), 2.0),
        "2 s after the launch tf does not know upper_arm, seen from world",
        hint="robot_state_publisher computes the frames, joint_state_publisher publishes the angles, and both need "
        f"/robot_description. Nodes that run: {', '.join(nodes) or 'none'}. "
        f"Parameters: {', '.join(sim.params.names()[:5]) or 'none'}.",
    )
    slider = slider_of(launched)
    for joint, angle in (("hip", 0.5), ("shoulder", -0.25)):
        expect(
            joint in [one.name for one in slider.joints],
            f"there is no slider for the joint {joint}",
            hint="There is a slider for each joint in robot_description that can move.",
        )
        slider.set_position(joint, angle)
    sim.run(0.3)
    seen = SeenRobot(sim, robots.robot(ROBOT))
    expect_to_follow(seen, robots.text(ROBOT), "upper_arm", hip=0.5, shoulder=-0.25)


@points(2)
def test_your_answers(submission):
    """The answers give the position of the tip, and the angles at which the arm points up and down."""
    expect_the_tip(submission, "tip_at_zero", hip=0.0, shoulder=0.0)
    for name, right in (("shoulder_raised", -math.pi / 2), ("shoulder_hanging", math.pi / 2)):
        told = given_answer(submission, name)
        expect(
            isinstance(told, int | float) and abs(math.remainder(told - right, math.tau)) < 0.03,
            f"{name} is not right",
            hint="A positive angle of the shoulder lowers the arm. Angles are in radians: a quarter turn is 1.5708.",
        )
    pose = pose_of(name_of(submission, "student"))
    expect_the_tip(submission, "tip_in_your_pose", hip=pose.hip, shoulder=pose.shoulder)


def expect_the_tip(submission, answer, *, hip, shoulder):
    """An answer gives the position of the tip at these angles; the usual mistakes are named."""
    told = given_answer(submission, answer)
    expect(
        is_near(told, arm_at(hip, shoulder)[1]),
        f"{answer} is not where the tip is with the hip at {hip:g} and the shoulder at {shoulder:g} rad",
        hint=mistake_in(told, hip, shoulder)
        or "Write three numbers in metres. Go from the tip to the ground: the length of the arm, the position of the "
        "shoulder on the torso, the rotation of the hip, the height of the base. Or move the sliders, and look.",
    )


def mistake_in(told, hip, shoulder):
    """What went wrong, if it is one of the usual mistakes; else an empty text."""
    base, tip = arm_at(hip, shoulder)
    x, y, z = tip
    unturned = (0.4 * math.cos(shoulder), -0.1, z)
    central = (x - 0.1 * math.sin(hip), y + 0.1 * math.cos(hip), z)
    in_degrees = arm_at(math.radians(hip), math.radians(shoulder))[1]
    mistakes = (
        (tip, ""),
        ((x, y, z - 0.05), "The height of the base is missing: it lifts everything by 0.05 m."),
        (
            (x, y, z - 0.5),
            "This height is relative to the shoulder, which is itself 0.5 m above the ground.",
        ),
        (central, "The shoulder is beside the torso, not in it: 0.1 m to the right."),
        (arm_at(hip, -shoulder)[1], "A positive angle of the shoulder LOWERS the arm."),
        (arm_at(-hip, shoulder)[1], "A positive angle of the hip turns LEFT, seen from above."),
        (unturned, "In this position the shoulder has turned, but not the hip."),
        (base, "This is the position of the shoulder; the tip is 0.4 m farther on."),
        (in_degrees, "The angles are in radians, not in degrees."),
    )
    return next((words for place, words in mistakes if is_near(told, place)), "")


def is_near(told, place):
    """Whether an answer is a position, to a centimetre."""
    try:
        return math.dist(told, place) < 0.01
    except (TypeError, ValueError, OverflowError):
        return False
