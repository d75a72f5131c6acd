"""Exercise 3.9, public checks: mass, inertia, collision, and an arm that swings as it must."""

import math

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer, words_of
from grader.checks.robots import RobotFiles, expect_chain
from oracles.swinging_arm import SwingingArm
from oracles.weights import expect_collision_as_visual, expect_cylinder_weight
from simkit.diagnostics import Severity

ROBOT = "hello_gazebo_robot_1.urdf"
LAUNCH = "spawn_gazebo_1.launch"
MODEL = "hello_ros_robot"
CYLINDERS = {"base_link": (0.05, 0.1), "torso": (0.5, 0.05), "upper_arm": (0.4, 0.05)}
"""Length and radius [m]."""


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def arm(sim, robots):
    """The student's robot in an empty world."""
    robots.robot(ROBOT)
    return sim.gazebo.spawn_urdf(robots.text(ROBOT), name=MODEL, file=ROBOT).model


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """ROS accepts hello_gazebo_robot_1.urdf: a chain from world to upper_arm."""
    robots.expect_clean(ROBOT, severity=Severity.ERROR)
    expect_chain(robots.robot(ROBOT), "world", *CYLINDERS)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_check_urdf_finds_nothing_wrong(robots):
    """check_urdf has no warning about hello_gazebo_robot_1.urdf either."""
    robots.expect_clean(ROBOT)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_each_link_has_its_weight(robots):
    """Each link has a mass of 1 kg, its centre of mass in the middle, and the inertia of a solid cylinder."""
    robot = robots.robot(ROBOT)
    for link, (length, radius) in CYLINDERS.items():
        expect_cylinder_weight(robot, link, mass=1.0, length=length, radius=radius)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_each_link_can_be_touched(robots):
    """The collision shape of each link is the same cylinder, in the same place, as its visual."""
    robot = robots.robot(ROBOT)
    for link in CYLINDERS:
        expect_collision_as_visual(robot, link)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_launch_file_brings_it_into_a_world(sim, roslaunch):
    """A second after the launch the model hello_ros_robot is in a world, with the joints hip and shoulder."""
    roslaunch(LAUNCH)
    sim.run(1.0)
    expect(
        sim.has_world,
        "the launch file starts no world",
        hint='Start a world with <include file="$(find gazebo_ros)/launch/empty_world.launch"/>.',
    )
    spawned = sim.gazebo.spawned
    others = ", ".join(name for name in spawned if name != "ground_plane") or "nothing"
    expect(
        MODEL in spawned,
        f"{MODEL} is not in the world; apart from the ground it contains: {others}",
        hint="spawn_model needs three arguments: -urdf, -param with the name of the parameter, and -model with the name in "
        "the world.",
    )
    joints = sorted(spawned[MODEL].model.joints)
    expect(
        joints == ["hip", "shoulder"],
        f"the model in the world has the joints: {', '.join(joints) or 'none'}",
        hint="Gazebo leaves out a link without mass if its joint can move, and the joint with it.",
    )


@points(2)
@after("test_each_link_has_its_weight")
def test_the_arm_swings_as_it_must(sim, arm):
    """Released from horizontal, hip and shoulder follow the equations of motion for 0.5 s."""
    reference = SwingingArm()
    for seconds in (0.1, 0.25, 0.5):
        sim.run(seconds - sim.world.time_ns * 1e-9)
        expect_close(
            (arm.joint("hip").position, arm.joint("shoulder").position),
            reference.swing(0.0, 0.0, seconds),
            tolerance=0.02,
            what=f"hip and shoulder {seconds} s after the start",
            unit="rad",
            hint="Are the joints in the right places, with the right axes? Does anything other than gravity act on them, "
            "such as a <dynamics> with damping or friction, or a limit?",
        )


@points(1)
def test_your_answers(submission):
    """The answers give the energy at the bottom, both periods, and the fate of a link without <inertial>."""
    arm = SwingingArm()
    drop = arm.mass * arm.gravity * arm.lever
    for name, right, tolerance, hint in (
        (
            "energy_at_the_bottom",
            drop,
            0.02,
            "The potential energy that the arm loses, m g l, becomes kinetic energy.",
        ),
        (
            "small_period",
            2 * math.pi * math.sqrt(arm.inertia / drop),
            0.01,
            "Use the inertia about the shoulder: that about the middle plus m l^2, with l = 0.2 m.",
        ),
        (
            "large_period",
            1.2305,
            0.012,
            "Hold the hip, as the cell does. The cell prints when the arm is back.",
        ),
    ):
        expect_close(
            given_answer(submission, name), right, tolerance=tolerance, what=name, hint=hint
        )
    expect(
        words_of(given_answer(submission, "without_inertial")) == ["b"],
        "without_inertial is not right",
        hint="Look at which links and joints are in the world once the arm has no <inertial>.",
    )
