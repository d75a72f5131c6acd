from __future__ import annotations

import subprocess
import sys

import pytest

TALKER = """\
import rospy
from std_msgs.msg import String
rospy.init_node("talker")
print("I am", rospy.get_param("~mood", "well"))
publisher = rospy.Publisher("chatter", String, queue_size=1)
while not rospy.is_shutdown():
    publisher.publish("hello")
    rospy.sleep(0.1)
"""
BROKEN = """\
import rospy
rospy.init_node("broken")
rospy.sleep(0.2)
print(1 / 0)
"""


def test_nodes_and_tools_on_a_simulation_that_a_line_makes(cells):
    shown = cells(
        "%rosrun turtlesim turtlesim_node",
        "%rosrun hello_ros talker.py _mood:=fine __name:=bob",
        "%rosnode list",
        "%rostopic echo -n 1 /chatter",
        "%rostopic pub /turtle1/cmd_vel geometry_msgs/Twist "
        '"{linear: {x: 1.0}, angular: {z: 0.5}}"',
        "%rostopic echo -n 1 /turtle1/cmd_vel/linear/x",
        "%rosnode kill /rostopic_1",
        "%rosservice call /spawn 4 2 0 turtle2",
        "%rosparam get /turtlesim/background_r",
        "%rosmsg show geometry_msgs/Point",
        "%rossrv show turtlesim/Kill",
        talker=TALKER,
    )
    assert all(cell.ok and cell.err == "" for cell in shown)
    lines = [cell.out.splitlines() for cell in shown]
    assert lines[0][0].endswith("Starting turtlesim with node name /turtlesim")
    assert lines[1] == ["I am fine"]
    assert lines[2] == ["/bob", "/turtlesim"]
    assert lines[3] == ['data: "hello"', "---"]
    assert lines[4] == [
        "publishing and latching message",
        "/rostopic_1 goes on; %rosnode kill /rostopic_1 ends it",
    ]
    assert lines[5] == ["1.0", "---"]
    assert lines[6] == ["killing /rostopic_1", "killed"]
    assert lines[7][-1] == 'name: "turtle2"'
    assert lines[8] == ["69"]
    assert lines[9] == ["float64 x", "float64 y", "float64 z", ""]
    assert lines[10] == ["string name", "---", ""]


def test_a_fault_at_the_start_shows_at_once(cells):
    (shown,) = cells("%rosrun hello_ros broken.py", broken=BROKEN)
    lines = shown.out.splitlines()
    assert lines[0] == "Traceback (most recent call last):"
    assert 'hello_ros/scripts/broken.py", line 4' in lines[1]
    assert lines[-2] == "ZeroDivisionError: division by zero"
    assert "process has died" in lines[-1]


def test_a_silent_simulation_shows_the_node_too(cells):
    shown = cells(
        "import simkit; sim = simkit.Simulation(screen=None)",
        "%rosrun hello_ros broken.py",
        "%rosrun hello_ros talker.py",
        "sim.nodes()",
        "%rosrun turtlesim turtle_teleop_key",
        broken=BROKEN,
        talker=TALKER,
    )
    assert shown[1].out.splitlines()[-2] == "ZeroDivisionError: division by zero"
    assert "process has died [exit code 1]: hello_ros/scripts/broken.py:4: " in shown[1].out
    assert shown[2].out == "I am well\n"
    assert "/talker" in shown[3].out
    assert "Use arrow keys" in shown[4].out


def test_the_newest_open_simulation_is_meant(cells):
    shown = cells(
        "import simkit\nfirst = simkit.Simulation()\nsecond = simkit.Simulation()",
        "%rosrun turtlesim turtlesim_node",
        "print(len(first.nodes()), len(second.nodes())); second.close()",
        "%rosnode list",
        "%rosrun turtlesim turtlesim_node",
        "print(len(first.nodes())); first.close()",
        "%rosnode list",
    )
    assert [cell.ok for cell in shown] == [True] * 7
    assert shown[2].out == "1 2\n"
    assert shown[3].out == "\n"
    assert shown[5].out == "2\n"
    assert shown[6].out == "\n"


def test_tf_echo_is_shown_for_a_moment(cells):
    shown = cells(
        "%rosrun tf static_transform_publisher 2 0 0 0 0 0 world carrot1 100",
        "%rosrun tf tf_echo /world /carrot1",
        "%rosnode list",
        "%rosrun tf tf_echo /world /carrot1 &",
        "%rosnode list",
        "%rostopic hz /tf",
        "%rostopic echo /tf/transforms[0]/child_frame_id",
    )
    assert shown[1].out.count("- Translation: [2.000, 0.000, 0.000]") in (2, 3)
    assert "tf_echo" not in shown[2].out
    assert "/tf_echo_1" in shown[4].out
    assert "average rate: 10.000" in shown[5].out
    assert shown[6].out.splitlines()[-1] == "(10 messages; -n COUNT shows so many)"


def test_rviz_is_shown_below_the_line_that_starts_it(cells):
    shown = cells(
        "%rosrun tf static_transform_publisher 2 0 0 0 0 0 world carrot1 100",
        "%rosrun rviz rviz",
        "%rosrun rviz rviz -f carrot2",
        "%rosrun rviz rviz --what",
        "%rosnode list",
    )
    assert shown[1].out == "RvizView('2 frames seen from world.')\n"
    assert "Fixed Frame [carrot2] does not exist. Did you mean [carrot1]?" in shown[2].out
    assert not shown[3].ok
    assert "rviz" not in shown[4].out


@pytest.mark.parametrize("asked", ["`rospack find hello_ros`", "$(rospack find hello_ros)"])
def test_a_line_may_ask_for_the_folder_of_a_package_as_in_a_shell(cells, asked):
    shown = cells(
        "open('hello_ros/robot.urdf', 'w').write('<robot name=\"r\"><link name=\"torso\"/></robot>') and None",
        f"%check_urdf {asked}/robot.urdf",
    )
    assert "root Link: torso has 0 child(ren)" in shown[1].out


@pytest.mark.parametrize(
    ("line", "text"),
    [
        (
            "%check_urdf `rospack find helo_ros`/robot.urdf",
            "%check_urdf: no package 'helo_ros'; did you mean 'hello_ros'?",
        ),
        (
            "%rosrun helo_ros talker.py",
            "%rosrun: no package 'helo_ros'; did you mean 'hello_ros'",
        ),
        (
            "%rosrun hello_ros talkr.py",
            "%rosrun: no executable in package 'hello_ros' 'talkr.py'; did you mean 'talker.py'?",
        ),
        ("%rosrun", "%rosrun: Usage: rosrun PACKAGE EXECUTABLE [ARGUMENTS]"),
        ("%rostopic info /nope", "%rostopic: ERROR: Unknown topic /nope"),
        ("%rostopic ech /x", "%rostopic: rostopic has no command 'ech'; did you mean echo?"),
        (
            "%rostopic pub /x geometry_msgs/Twist '{linear: {q: 1}}'",
            "%rostopic: ERROR: No field name [linear.q]; ",
        ),
        ("%rostopic pub /x std_msgs/String 'hello", "No closing quotation; quotation marks come"),
        ("%rosmsg show geometry_msgs/Twst", "%rosmsg: no message type 'geometry_msgs/Twst'; did"),
    ],
)
def test_an_error_is_one_line(cells, line, text):
    (shown,) = cells(line, talker=TALKER)
    assert not shown.ok
    said = (shown.out + shown.err).strip()
    assert text in said
    assert len(said.splitlines()) == 1


def test_a_plain_traceback_of_a_lookup_has_its_hint(cells):
    (shown,) = cells(
        "import simkit; simkit.Simulation().tf.lookup_transform('world', 'turtle1')",
    )
    assert not shown.ok
    assert "hint: No transform has arrived yet." in shown.out + shown.err


def test_a_new_package_and_a_node_in_it(cells):
    shown = cells(
        "%catkin_create_pkg my_lab rospy tf",
        "open('my_lab/scripts/hello.py', 'w').write('print(1)') and None",
        "%rosrun my_lab hello.py",
        "%catkin_create_pkg my_lab",
        "%catkin_create_pkg",
    )
    assert "Created file my_lab/package.xml" in shown[0].out
    assert shown[2].out == "1\n"
    assert [cell.ok for cell in shown[3:]] == [False, False]


def test_the_lines_are_explained(cells):
    (shown,) = cells("print(get_ipython().find_line_magic('rosrun').__doc__)")
    assert shown.out.startswith("Run a node of a package.\n")
    assert "if a & is the last word" in shown.out


def test_simkit_alone_does_not_load_ipython():
    program = "import sys, simkit; assert 'IPython' not in sys.modules; simkit.Simulation"
    subprocess.run([sys.executable, "-c", program], check=True)
