"""Exercise 3.6, public checks: a base of one's own, a parameter, and a signpost that is fixed."""

import pytest

from grader.checks import after, expect, expect_close, expect_equal, points
from grader.checks.answers import given_answer, words_of
from grader.checks.personal import base_of, name_of
from grader.checks.robots import RobotFiles, cylinder_of, expect_chain, expect_firm
from oracles.moved_robot import MovedRobot
from simkit.diagnostics import Severity

ROBOT = "hello_ros_robot_1.urdf"
LAUNCH = "urdf_launch_1.launch"
SIGNPOST = "signpost.urdf"
KINDS = ("box", "cylinder", "sphere", "mesh")
PLAUSIBLE = (0.001, 10.0)
"""Radius and length of a base that is to be seen, also where it is not the one asked for [m]."""


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """ROS accepts hello_ros_robot_1.urdf: base_link is fixed to world."""
    robots.expect_clean(ROBOT, severity=Severity.ERROR)
    robot = robots.robot(ROBOT)
    expect_chain(robot, "world", "base_link")
    expect_firm(robot, "base_link")


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_check_urdf_finds_nothing_wrong(robots):
    """check_urdf has no warning about hello_ros_robot_1.urdf either."""
    robots.expect_clean(ROBOT)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_base_has_your_size(robots, submission):
    """base_link is a cylinder with the radius and the length that base_of gives for your name."""
    _, shape = cylinder_of(robots.robot(ROBOT), "base_link")
    name = name_of(submission, "student")
    task = base_of(name)
    expect(
        (shape.radius, shape.length) != (task.length, task.radius),
        "radius and length are swapped",
        hint="The radius is half the width, and the length runs along z, from the lower end to the upper.",
    )
    hint = "base_of gives the numbers for your name, in metres. The radius is half the width, and the length runs along z."
    for what, found, wanted in (
        ("radius", shape.radius, task.radius),
        ("length", shape.length, task.length),
    ):
        expect_close(
            found,
            wanted,
            tolerance=1e-6,
            what=f"the {what} of the base of {name!r}",
            unit="m",
            hint=hint,
        )


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_base_has_your_colour(robots, submission):
    """base_link has the colour that base_of gives for your name."""
    material = visible_base(robots.robot(ROBOT))[0].material
    expect(
        material is not None and material.rgba is not None,
        "base_link has no colour",
        hint='Write <material name="..."><color rgba="red green blue opacity"/></material> in <visual>.',
    )
    expect_close(
        material.rgba,
        base_of(name_of(submission, "student")).rgba,
        tolerance=0.01,
        what="the colour (red, green, blue, opacity)",
        hint="Write four numbers from 0 to 1 with spaces between them, as base_of prints them.",
    )


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_base_stands_on_the_ground(sim, robots):
    """The cylinder stands upright, with its lower end at height 0 and its middle above the origin."""
    robot = robots.robot(ROBOT)
    _, shape = visible_base(robot)
    ends = MovedRobot(sim, robot, robots.text(ROBOT)).ends("base_link")
    lower, upper = sorted(ends, key=lambda end: end[2])
    expect_close(
        upper[2] - lower[2],
        shape.length,
        tolerance=1e-5,
        what="the height from the lower end to the upper",
        unit="m",
        hint="A cylinder stands along z by itself, so leave rpy at 0 0 0.",
    )
    expect_close(
        lower,
        (0.0, 0.0, 0.0),
        tolerance=1e-4,
        what="the middle of the lower end",
        unit="m",
        frame="world",
        hint="The origin of the visual is the middle of the cylinder, so it is half its length above the ground. An "
        "<origin> of the joint would be added to it.",
    )


def visible_base(robot):
    """The cylinder of base_link, with its visual; one that nobody could see has neither colour nor height."""
    visual, shape = cylinder_of(robot, "base_link")
    low, high = PLAUSIBLE
    for what, found in (("radius", shape.radius), ("length", shape.length)):
        expect(
            low <= found <= high,
            f"the {what} of the base is {found:g} m, where {low:g} to {high:g} m can be seen",
            hint="base_of gives the numbers for your name, in metres.",
        )
    return visual, shape


@points(2)
def test_the_launch_file_sets_the_description(sim, roslaunch, robots):
    """The launch file puts the text of hello_ros_robot_1.urdf into the parameter robot_description."""
    roslaunch(LAUNCH)
    known = sim.params.names()
    expect(
        "/robot_description" in known,
        "there is no parameter /robot_description after the launch",
        hint='Set it with <param name="robot_description" textfile="$(find hello_ros)/urdf/..."/>. '
        f"Parameters that exist: {', '.join(known[:5]) or 'none'}.",
    )
    expect_the_text(sim.params.get("/robot_description"), robots.text(ROBOT))


def expect_the_text(found, wanted):
    """The parameter holds the text of the file, and that text is a robot."""
    expect(
        "<robot" in wanted,
        f"{ROBOT} contains no <robot>: there is nothing to put on the parameter server yet",
        hint="Write your robot first, and run its cell. Then launch again.",
    )
    words = str(found).split()
    if words == wanted.split():
        return
    expect(
        "<robot" in str(found),
        f"robot_description is {str(found)[:60]!r}, which is not a URDF",
        hint="With value= the parameter is the text that you write there; with textfile= it is the content of a file.",
    )
    expect(
        False,
        "robot_description describes another robot",
        hint="Which file does your textfile= name?",
    )


@points(1)
def test_the_signpost_is_mended(robots):
    """check_urdf finds nothing wrong with signpost.urdf, and its three links form the tree that was meant."""
    robots.expect_clean(SIGNPOST)
    robot = robots.robot(SIGNPOST)
    tree = {
        child: parent.parent for child in ("pole", "sign") if (parent := robot.joint_above(child))
    }
    expect_equal(
        tree,
        {"pole": "base_link", "sign": "pole"},
        what="which link is attached to which",
        hint="Fix the signpost, but keep its three links and two joints.",
    )


@points(1)
def test_your_answers(submission):
    """The answers give the kind of object that the base is, and the axis along which it stands."""
    words = " ".join(words_of(given_answer(submission, "shape"))).lower().split()
    expect(
        [word for word in words if word in KINDS] == ["cylinder"],
        "shape is not the kind of object that the file describes",
        hint="Look inside <geometry>: the name of the tag there is the kind of object.",
    )
    expect(
        [word.lower() for word in words_of(given_answer(submission, "standing_axis"))] == ["z"],
        "standing_axis is not the axis that the object stands along",
        hint="With rpy 0 0 0 the base stands upright. Which axis points up?",
    )
