from __future__ import annotations

import pytest


def test_list(command):
    assert command("rosservice", "list", "/turtle1").split() == [
        "/turtle1/set_pen",
        "/turtle1/teleport_absolute",
        "/turtle1/teleport_relative",
    ]
    assert command("rosservice", "list", "-n").splitlines()[0] == "/clear /turtlesim"


def test_info_type_args_node_and_find(command):
    assert command("rosservice", "info", "/spawn") == (
        "Node: /turtlesim\nURI: simkit://turtlesim\nType: turtlesim/Spawn\nArgs: x y theta name\n"
    )
    assert command("rosservice", "type", "spawn") == "turtlesim/Spawn\n"
    assert command("rosservice", "args", "/spawn") == "x y theta name\n"
    assert command("rosservice", "node", "/spawn") == "/turtlesim\n"
    assert command("rosservice", "find", "std_srvs/Empty").split() == ["/clear", "/reset"]


@pytest.mark.parametrize(
    "words", [["4", "2", "0", "turtle2"], ["{x: 4, y: 2, name: turtle2}"], ["4", "2", "0.0", ""]]
)
def test_call(sim, command, words):
    assert command("rosservice", "call", "/spawn", *words) == 'name: "turtle2"\n'
    assert "/turtle2/pose" in sim.topics()


def test_call_of_an_empty_service(command):
    assert command("rosservice", "call", "/clear") == "\n"


def test_call_of_a_script(sim, command, refusal, tmp_path):
    package = tmp_path / "play"
    package.mkdir()
    (package / "package.xml").write_text("<package/>")
    (package / "server.py").write_text(
        "import rospy\n"
        "from std_srvs.srv import SetBool, Trigger\n"
        "rospy.init_node('server')\n"
        "rospy.sleep(1.0)\n"
        "rospy.Service('switch', SetBool, lambda r: (r.data, 'now %s' % r.data))\n"
        "rospy.Service('fails', Trigger, lambda r: None)\n"
        "rospy.spin()\n"
    )
    sim.rosrun("play", "server.py")
    assert command("rosservice", "call", "--wait", "/switch", "true").splitlines() == [
        "success: True",
        'message: "now True"',
    ]
    text, code = refusal("rosservice", "call", "/fails")
    assert text == (
        "ERROR: service [/fails] responded with an error: "
        "b'service cannot process request: service handler returned None'"
    )
    assert code == 2


@pytest.mark.parametrize(
    ("words", "text", "code"),
    [
        (["call", "/nope"], "ERROR: Service [/nope] is not available.", 2),
        (
            ["call", "/spwan", "1"],
            "ERROR: Service [/spwan] is not available.\nhint: did you mean /spawn?",
            2,
        ),
        (
            ["call", "/spawn", "1", "2"],
            "Provided arguments are:\n * 1 (type int)\n * 2 (type int)\n\n"
            "Service arguments are: [x y theta name]",
            2,
        ),
        (["call", "/spawn", "{z: 1}"], "ERROR: Incompatible arguments to call service:\n", 2),
        (
            ["call", "/spawn", "{x: far}"],
            "\n\nsrv file:\nfloat32 x\nfloat32 y\nfloat32 theta\nstring name\n---\nstring name\n",
            2,
        ),
        (
            ["call", "/kill", "nobody"],
            "ERROR: service [/kill] responded with an error: b''",
            2,
        ),
        (["call", "/spawn"], "Please specify service arguments: x y theta name", 2),
        (["call", "/spawn", "{"], "'{' is not YAML", 2),
        (["info", "/nope"], "ERROR: unknown service", 1),
        (["type", "/nope"], "Unknown service [/nope]", 1),
        (["node", "/nope"], "Unknown service: /nope", 1),
    ],
)
def test_what_is_wrong(refusal, words, text, code):
    said, exit_code = refusal("rosservice", *words)
    assert text in said
    assert exit_code == code
