"""Launch files of a student in checks."""

import pytest

from grader.results import Status

TALK = "hello_ros/scripts/talk.py"
LAUNCH = "hello_ros/launch/a.launch"
NODE = '<node name="t" pkg="hello_ros" type="talk.py"/>'


@pytest.fixture
def launched(run_checks, workbook):
    """A function that grades a launch file and a script by the body of one check."""

    def launched(inner, body, script="import rospy\nrospy.init_node('t')\nrospy.spin()\n"):
        files = {LAUNCH: f"<launch>{inner}</launch>", TALK: script}
        submission = workbook.submission(files=files, fixed_frame="world")
        lines = "\n".join(f"            {line}" for line in body.strip().splitlines())
        checks = f"""
        def test_x(sim, roslaunch, launch_plan):
{lines}
        """
        return run_checks(checks, submission)["x"]

    return launched


def test_a_launch_and_its_plan(launched):
    check = launched(
        '<arg name="n" default="t"/><node name="$(arg n)" pkg="hello_ros" type="talk.py">'
        '<param name="speed" value="2.5"/></node>',
        """
plan = launch_plan("a.launch", "n:=bob")
expect_equal(dict(plan.params), {"/bob/speed": 2.5}, what="the parameters")
expect_equal(sim.params.names(), [], what="what was set by the plan alone")
launch = roslaunch("a.launch", "n:=bob")
sim.run(0.5)
expect_equal(list(launch.nodes), ["/bob"], what="the nodes")
expect_equal(sim.params.get("/bob/speed"), 2.5, what="the speed")
expect(launch.alive, "It has ended.")
""",
    )
    assert (check.status, check.message) == (Status.PASSED, "")


def test_a_launch_file_that_roslaunch_refuses_is_the_students(launched):
    check = launched('<node nam="t"/>', 'roslaunch("a.launch")')
    assert check.status is Status.FAILED
    assert "missing required attribute: 'name'" in check.message
    assert "hello_ros/launch/a.launch:1:10: error [LCH-E07]" in check.message
    assert check.hint == "Write name= where nam= stands."


def test_what_becomes_of_its_nodes_is_told(launched):
    body = 'roslaunch("a.launch")\nsim.run(1.0)\nexpect(False, "Nobody talks.")'
    check = launched(NODE, body, "import rospy\nrospy.init_node('t')\n1 / 0\n")
    assert check.status is Status.ERROR
    assert check.message.startswith("hello_ros/scripts/talk.py:3: the script stopped with an error")
    check = launched(NODE.replace("talk", "tlak"), body)
    assert check.status is Status.FAILED
    assert check.message.startswith(
        "a.launch: ERROR: cannot launch node of type [hello_ros/tlak.py]: Cannot locate node"
    )
    check = launched(NODE, body, "print('bye')\n")
    assert "talk.py had already ended" in check.message


def test_what_it_may_not_is_told(launched):
    check = launched(
        '<param name="a" value="1"/>' + NODE,
        'launch = roslaunch("a.launch")\nsim.run(0.5)\nexpect(sim.params.has("/a"), "No a.")',
    )
    assert check.status is Status.FAILED
    assert "a.launch: this launch file sets the parameter /a, which this exercise" in check.message


def test_a_launch_file_that_was_not_handed_in_is_named(launched):
    check = launched("", 'roslaunch("b.launch")')
    assert "b.launch was not handed in" in check.message
