"""Exercise 3.8, public checks: an arm with two joints, and where its tip is."""

import math

import pytest

from grader.checks import after, expect, expect_close, expect_close_angle, points
from grader.checks.answers import given_answer
from grader.checks.moved_robot import MovedRobot, require_joint
from grader.checks.robots import RobotFiles, expect_chain, expect_silver_cylinder, slider_of

ROBOT = "hello_ros_robot_3.urdf"
LAUNCH = "urdf_launch_3.launch"


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
    """check_urdf finds nothing wrong with hello_ros_robot_3.urdf: a chain from world to upper_arm."""
    robots.expect_clean(ROBOT)
    expect_chain(robots.robot(ROBOT), "world", "base_link", "torso", "upper_arm")


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_upper_arm_has_its_shape(robots):
    """The upper arm is a silver cylinder, 0.4 m long, with a radius of 0.05 m."""
    expect_silver_cylinder(robots.robot(ROBOT), "upper_arm", length=0.4, radius=0.05)


@points(1)
@after("test_the_upper_arm_has_its_shape")
def test_at_zero_the_arm_points_forward(moved):
    """With both joints at 0 the arm points forward, level with the ground, from the shoulder beside the torso."""
    expect_the_arm(
        moved,
        hip=0.0,
        shoulder=0.0,
        hint="The shoulder is at 0 -0.1 0.45 on the torso, turned by rpy 0 1.5708 0. The middle of the arm is "
        "half its length along the z axis of its own frame.",
    )


@points(2)
@after("test_at_zero_the_arm_points_forward")
def test_the_joints_carry_the_arm(moved, rng):
    """For random angles of hip and shoulder, both ends of the arm are where forward kinematics says."""
    expect_the_arm(
        moved,
        hip=0.0,
        shoulder=rng.uniform(0.3, 1.2),
        hint="The shoulder turns about its y axis; a positive angle lowers the arm.",
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


@points(2)
@after("test_check_urdf_takes_your_robot")
def test_the_launch_file_brings_two_sliders(sim, roslaunch):
    """After the launch tf knows upper_arm, and two sliders move hip and shoulder."""
    launched = roslaunch(LAUNCH)
    names = [name for name in sim.nodes() if name != "/simkit"]
    expect(
        sim.run_until(lambda: sim.tf.can_transform("world", "upper_arm"), 2.0),
        "2 s after the launch tf does not know upper_arm, seen from world",
        hint="robot_state_publisher makes the frames, joint_state_publisher says the angles, and both need "
        f"robot_description. Nodes that run: {', '.join(names) or 'none'}.",
    )
    slider = slider_of(launched)
    for joint, angle in (("hip", 0.5), ("shoulder", -0.25)):
        slider.set_position(joint, angle)
    sim.run(0.3)
    state = sim.latest("/joint_states")
    angles = dict(zip(state.name, state.position, strict=True))
    expect_close(
        (angles.get("hip"), angles.get("shoulder")),
        (0.5, -0.25),
        tolerance=1e-3,
        what="the angles of hip and shoulder after their sliders were moved",
        unit="rad",
    )


@points(2)
def test_your_answers(submission):
    """The answers say where the tip is, and at which angles the arm points up and down."""
    for name, hip in (("tip_at_zero", 0.0), ("tip_turned", math.pi / 2)):
        expect_close(
            given_answer(submission, name),
            arm_at(hip, 0.0)[1],
            tolerance=0.01,
            what=name,
            unit="m",
            frame="world",
            hint="Go from the tip to the ground: the length of the arm, the shoulder's place on the torso, "
            "the turn of the hip, the height of the base. Or move the sliders, and look.",
        )
    for name, right in (("shoulder_raised", -math.pi / 2), ("shoulder_hanging", math.pi / 2)):
        expect_close_angle(
            given_answer(submission, name),
            right,
            tolerance=0.03,
            what=name,
            hint="A positive angle of the shoulder lowers the arm. Angles are in radians: a quarter turn is 1.5708.",
        )
