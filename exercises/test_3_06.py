"""Exercise 3.6, public checks: a base of one's own, a parameter, and a signpost that is mended."""

import pytest

from grader.checks import after, expect, expect_close, expect_equal, points
from grader.checks.answers import given_answer
from grader.checks.personal import base_of, name_of
from grader.checks.robots import RobotFiles, only_visual
from simkit.urdf import Cylinder

ROBOT = "hello_ros_robot_1.urdf"
LAUNCH = "urdf_launch_1.launch"
SIGNPOST = "signpost.urdf"


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@points(1)
def test_check_urdf_takes_your_robot(robots):
    """check_urdf finds nothing wrong with hello_ros_robot_1.urdf: base_link hangs on world."""
    robots.expect_clean(ROBOT)
    robot = robots.robot(ROBOT)
    expect_equal(robot.root, "world", what="the root of the tree")
    above = robot.joint_above("base_link") if "base_link" in robot.links else None
    expect(
        above is not None and above.parent == "world" and not above.moves,
        "base_link does not hang on world by a fixed joint",
        hint='The joint has type="fixed", <parent link="world"/> and <child link="base_link"/>.',
    )


@points(2)
@after("test_check_urdf_takes_your_robot")
def test_the_base_has_your_size(robots, submission):
    """base_link is a cylinder with the radius and the length that your name gives."""
    shape = only_visual(robots.robot(ROBOT), "base_link").geometry
    expect(
        isinstance(shape, Cylinder),
        f"base_link is a {type(shape).__name__.lower()}, not a cylinder",
        hint="Inside <geometry> stands <cylinder length=... radius=.../>.",
    )
    task = base_of(name_of(submission, "student"))
    hint = "Ask base_of for the numbers of your name. The radius is half the width; the length runs along z."
    expect_close(shape.radius, task.radius, tolerance=1e-6, what="the radius", unit="m", hint=hint)
    expect_close(shape.length, task.length, tolerance=1e-6, what="the length", unit="m", hint=hint)


@points(1)
@after("test_check_urdf_takes_your_robot")
def test_the_base_has_your_colour(robots, submission):
    """base_link has the colour that your name gives."""
    material = only_visual(robots.robot(ROBOT), "base_link").material
    expect(
        material is not None and material.rgba is not None,
        "base_link has no colour",
        hint='<material name="..."><color rgba="red green blue opacity"/></material>, in <visual>.',
    )
    expect_close(
        material.rgba,
        base_of(name_of(submission, "student")).rgba,
        tolerance=0.01,
        what="the colour (red, green, blue, opacity)",
        hint="Four numbers from 0 to 1 with blanks between them, as base_of shows them.",
    )


@points(1)
@after("test_the_base_has_your_size")
def test_the_base_stands_on_the_ground(robots):
    """The cylinder stands upright, with its lower end at height 0 and its middle above the origin."""
    robot = robots.robot(ROBOT)
    visual = only_visual(robot, "base_link")
    joint = robot.joint_above("base_link")
    roll, pitch, _ = visual.origin.rpy
    expect_close(
        (roll, pitch, *joint.origin.rpy),
        (0.0, 0.0, 0.0, 0.0, 0.0),
        tolerance=1e-6,
        what="the tilt of the cylinder (roll, pitch) and of its frame",
        unit="rad",
        hint="A cylinder stands along z by itself: leave rpy at 0 0 0.",
    )
    x, y, z = (a + b for a, b in zip(visual.origin.xyz, joint.origin.xyz, strict=True))
    expect_close(
        (x, y, z - visual.geometry.length / 2),
        (0.0, 0.0, 0.0),
        tolerance=1e-6,
        what="the middle of the lower end",
        unit="m",
        frame="world",
        hint="The origin is the middle of the cylinder: half its length above the ground.",
    )


@points(2)
def test_the_launch_file_sets_the_description(sim, roslaunch, robots):
    """The launch file puts the text of hello_ros_robot_1.urdf into the parameter robot_description."""
    roslaunch(LAUNCH)
    known = sim.params.names()
    expect(
        "/robot_description" in known,
        "there is no parameter /robot_description after the launch",
        hint='<param name="robot_description" textfile="$(find hello_ros)/urdf/..."/>. '
        f"Parameters that are there: {', '.join(known[:5]) or 'none'}.",
    )
    expect_the_text(sim.params.get("/robot_description"), robots.text(ROBOT))


def expect_the_text(found, wanted):
    """The parameter holds the text of the file."""
    words = str(found).split()
    if words == wanted.split():
        return
    expect(
        "<robot" in str(found),
        f"robot_description is {str(found)[:60]!r}, and that is no URDF",
        hint="value= sets the text itself; textfile= reads it from a file.",
    )
    expect(False, "robot_description is another robot", hint="Which file does your textfile name?")


@points(1)
def test_the_signpost_is_mended(robots):
    """check_urdf finds nothing wrong with signpost.urdf, and its three links hang together."""
    robots.expect_clean(SIGNPOST)
    robot = robots.robot(SIGNPOST)
    tree = {
        child: parent.parent for child in ("pole", "sign") if (parent := robot.joint_above(child))
    }
    expect_equal(
        tree,
        {"pole": "base_link", "sign": "pole"},
        what="what hangs on what",
        hint="Mend the signpost, and leave its links and joints as they are: three links, two joints.",
    )


@points(1)
def test_your_answers(submission):
    """The answers say what kind of object the base is, and along which axis it stands."""
    expect(
        given_answer(submission, "shape") == "cylinder",
        "shape is not the kind of object that the file describes",
        hint="Look inside <geometry>: the name of the tag is the kind of object.",
    )
    expect(
        str(given_answer(submission, "standing_axis")).strip().lower() == "z",
        "standing_axis is not the axis that the object stands along",
        hint="With rpy 0 0 0 the base stands upright. Which axis points up?",
    )
