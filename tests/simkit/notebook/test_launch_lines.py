"""`%roslaunch` in a notebook."""

from __future__ import annotations

import pytest

TALKER = """\
import rospy
rospy.init_node("talker")
print("I am", rospy.get_param("~mood", "well"))
rospy.spin()
"""
LAUNCH = """<launch>
  <arg name="mood" default="fine"/>
  <param name="speed" value="2.5"/>
  <node name="bob" pkg="hello_ros" type="talker.py" args="_mood:=$(arg mood)" output="screen"/>
  <node name="shy" pkg="hello_ros" type="talker.py"/>
</launch>
"""
WRITE = "open('hello_ros/talk.launch', 'w').write('''{}''') and None"


def test_the_summary_and_what_nodes_say_stand_below_the_line(cells):
    shown = cells(
        WRITE.format(LAUNCH),
        "%roslaunch hello_ros talk.launch mood:=great",
        "%rosnode list",
        "%rosparam get /speed",
        "%roslaunch hello_ros/talk.launch --screen",
        "%rosnode list",
        talker=TALKER,
    )
    assert [cell.ok for cell in shown] == [True] * 6
    out = shown[1].out
    assert out.startswith("SUMMARY\n========\n\nPARAMETERS\n * /speed: 2.5\n\nNODES\n  /\n")
    assert "process[bob-1]: started hello_ros/talker.py\n" in out
    assert out.count("I am") == 1
    assert "I am great\n" in out
    assert "note: what /shy prints is not shown" in out
    assert shown[2].out.split() == ["/bob", "/shy"]
    assert shown[3].out == "2.5\n\n" or shown[3].out == "2.5\n"
    assert shown[4].out.count("I am") == 2
    assert shown[5].out.split() == ["/bob", "/shy"]


def test_lists_start_nothing(cells):
    shown = cells(
        WRITE.format(LAUNCH),
        "%roslaunch hello_ros talk.launch --nodes",
        "%roslaunch --dump-params hello_ros talk.launch mood:=great",
        "%roslaunch hello_ros talk.launch --args bob",
        "%rosnode list",
        talker=TALKER,
    )
    assert shown[1].out == "/bob\n/shy\n"
    assert shown[2].out == "/speed: 2.5\n\n"
    assert shown[3].out.endswith("talker.py _mood:=fine __name:=bob\n")
    assert shown[4].out.strip() == ""


def test_help_is_no_error(cells):
    (shown,) = cells("%roslaunch -h")
    assert shown.ok
    assert shown.out.startswith("usage: roslaunch [OPTIONS] PACKAGE FILE [NAME:=VALUE]\n")
    assert "--dump-params" in shown.out


def test_a_cell_that_is_run_again_replaces_its_nodes(cells):
    shown = cells(
        WRITE.format(LAUNCH),
        "%roslaunch hello_ros talk.launch",
        "%roslaunch hello_ros talk.launch",
        "%rosnode list",
        talker=TALKER,
    )
    assert "hello_ros/talk.launch runs already: its nodes end, and start anew\n" in shown[2].out
    assert shown[2].out.count("I am fine\n") == 1
    assert shown[3].out.split() == ["/bob", "/shy"]


def test_a_silent_simulation_shows_the_launch_too(cells):
    shown = cells(
        "import simkit; sim = simkit.Simulation(screen=None)",
        WRITE.format(LAUNCH),
        "%roslaunch hello_ros talk.launch",
        talker=TALKER,
    )
    assert "process[bob-1]: started" in shown[2].out
    assert "I am fine\n" in shown[2].out
    assert "I am well" not in shown[2].out


@pytest.mark.parametrize(
    ("line", "texts"),
    [
        ("%roslaunch", ["usage: roslaunch PACKAGE FILE"]),
        (
            "%roslaunch hello_ros talk.launch mood=good",
            ["Write mood:=good, with a colon.", "LCH-E13"],
        ),
        ("%roslaunch hello_ros talk.launch --args tom", ["Cannot find node named [/tom]"]),
        (
            "%roslaunch hello_ros tlk.launch",
            ["RLException: [tlk.launch] is neither a launch file", "Did you mean talk.launch"],
        ),
        (
            "%roslaunch hello_ros bad.launch",
            [
                "RLException: Invalid roslaunch XML syntax: mismatched tag: line 2, column 2",
                "hello_ros/bad.launch:",
                "LCH-E04",
            ],
        ),
    ],
)
def test_an_error_has_both_layers_and_no_traceback(cells, line, texts):
    bad = "open('hello_ros/bad.launch', 'w').write('<launch><node>\\n</launch>') and None"
    *_, shown = cells(WRITE.format(LAUNCH), bad, line, talker=TALKER)
    assert not shown.ok
    said = shown.out + shown.err
    for text in texts:
        assert text in said
    assert "Traceback" not in said
