from __future__ import annotations

import pytest

INFO = """\
--------------------------------------------------------------------------------
Node [/turtlesim]
Publications: 
 * /turtle1/color_sensor [turtlesim/Color]
 * /turtle1/pose [turtlesim/Pose]

Subscriptions: 
 * /turtle1/cmd_vel [geometry_msgs/Twist]

Services: 
 * /clear
 * /kill
 * /reset
 * /spawn
 * /turtle1/set_pen
 * /turtle1/teleport_absolute
 * /turtle1/teleport_relative


contacting node simkit://turtlesim ...
Connections:
 * topic: /turtle1/pose
    * to: /mimic
    * direction: outbound
    * transport: simkit

"""  # noqa: W291 - the blanks are those of ROS


def test_list(sim, command):
    sim.rosrun("turtlesim", "turtle_teleop_key", "__ns:=/lab")
    assert command("rosnode", "list") == "/lab/teleop_turtle\n/turtlesim\n"
    assert command("rosnode", "list", "/lab") == "/lab/teleop_turtle\n"
    assert command("rosnode", "list", "-a").splitlines()[1] == "/turtlesim \tsimkit://turtlesim"


def test_info(sim, command):
    sim.rosrun("turtlesim", "mimic", "__name:=mimic", "input/pose:=turtle1/pose")
    assert command("rosnode", "info", "/turtlesim") == INFO
    mimic = command("rosnode", "info", "mimic")
    assert "Publications: \n * /output/cmd_vel [geometry_msgs/Twist]\n\nSubscriptions: \n" in mimic
    assert "Services: None\n" in mimic
    assert "    * to: /turtlesim\n    * direction: inbound\n" in mimic


def test_info_of_nobody(refusal):
    text, _ = refusal("rosnode", "info", "/turtlesi")
    assert "Publications: None" in text
    assert text.endswith("cannot contact [/turtlesi]: unknown node\nhint: did you mean /turtlesim?")


def test_ping(sim, command, refusal):
    start = sim.now
    assert command("rosnode", "ping", "-c", "3", "/turtlesim").splitlines() == [
        "rosnode: node is [/turtlesim]",
        "pinging /turtlesim with a timeout of 3.0s",
        *["xmlrpc reply from simkit://turtlesim\ttime=0.000000ms"] * 3,
        "ping average: 0.000000ms",
    ]
    assert (sim.now - start).to_sec() == 2.0
    assert command("rosnode", "ping", "/turtlesim", seconds=2).count("reply") == 2
    assert command("rosnode", "ping", "-a").count("reply") == 1
    assert "cannot ping [/nope]: unknown node" in refusal("rosnode", "ping", "nope")[0]
    assert "Please enter a node to ping" in refusal("rosnode", "ping")[0]


def test_kill(sim, command):
    sim.rosrun("turtlesim", "turtle_teleop_key")
    assert command("rosnode", "kill", "/teleop_turtle") == "killing /teleop_turtle\nkilled\n"
    assert sim.nodes() == ["/simkit", "/turtlesim"]
    sim.rosrun("turtlesim", "turtle_teleop_key")
    assert command("rosnode", "kill", "-a") == (
        "killing:\n * /teleop_turtle\n * /turtlesim\nkilled\n"
    )
    assert sim.nodes() == ["/simkit"]


def test_kill_gives_a_script_time_for_its_last_words(sim, command, tmp_path):
    package = tmp_path / "play"
    package.mkdir()
    (package / "package.xml").write_text("<package/>")
    (package / "polite.py").write_text(
        "import rospy\n"
        "rospy.init_node('polite')\n"
        "rospy.on_shutdown(lambda: print('bye'))\n"
        "rospy.spin()\n"
    )
    node = sim.rosrun("play", "polite.py")
    sim.run(0.1)
    command("rosnode", "kill", "polite")
    assert not node.alive
    assert node.output == "bye\n"


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (
            ["/turtlesin", "/other"],
            "ERROR: Unknown node(s):\n * /turtlesin\n * /other\nhint: did you mean /turtlesim?",
        ),
        (["/turtlesim", "/simkit"], "ERROR: Unknown node(s):\n * /simkit"),
        (["-a", "/turtlesim"], "invalid arguments with kill all (-a) option"),
        ([], "Please name the node to kill. Nodes:\n/turtlesim"),
    ],
)
def test_kill_of_nobody_kills_nobody(sim, refusal, words, text):
    assert text in refusal("rosnode", "kill", *words)[0]
    assert sim.nodes() == ["/simkit", "/turtlesim"]
