"""Launch files beside a robot."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

ROBOT = '<link name="base"/>'
STATES = (
    ROBOT
    + '<gazebo><plugin name="s" filename="libgazebo_ros_joint_state_publisher.so"><jointName>x</jointName></plugin></gazebo>'
)
PARAM = '<param name="robot_description" textfile="$(find hello_ros)/urdf/robot.urdf"/>'
STATE_NODE = '<node name="rsp" pkg="robot_state_publisher" type="robot_state_publisher"/>'
SPAWN = '<node name="spawn" pkg="gazebo_ros" type="spawn_model" args="-urdf -param {} -model r"/>'


def launch(*inside):
    return "\n".join(["<launch>", *inside, "</launch>"])


@pytest.mark.parametrize(
    "inside",
    [
        [PARAM, STATE_NODE, SPAWN.format("robot_description")],
        [
            PARAM.replace("robot_description", "/robot_description"),
            SPAWN.format("/robot_description"),
        ],
        [
            PARAM.replace("textfile=", "command=")
            .replace("$(find", "cat '$(find")
            .replace('urdf"', "urdf'\""),
            STATE_NODE,
        ],
        ['<include file="$(find other)/launch/upload.launch"/>', STATE_NODE],
        ['<param name="$(arg name)" value="x"/>', STATE_NODE],
        [SPAWN.format("$(arg name)")],
        ['<include file="$(find gazebo_ros)/launch/empty_world.launch"/>'],
    ],
)
def test_launch_files_that_fit(told, inside):
    found = told(ROBOT, launch=launch(*inside))
    assert [one for one in found if one.rule.startswith("LCH")] == []


def test_files_of_the_book_have_only_notes(told):
    gui = '<param name="use_gui" value="true"/>'
    nodes = (
        '<node name="jsp" pkg="joint_state_publisher" type="joint_state_publisher"/>' + STATE_NODE
    )
    (one,) = [one for one in told(ROBOT, launch=launch(PARAM, gui, nodes)) if one.rule[:3] == "LCH"]
    assert (one.rule, one.severity, one.file, one.span.line) == (
        "LCH-W05",
        Severity.NOTE,
        "robot.launch",
        3,
    )


@pytest.mark.parametrize(
    ("inside", "line", "what", "remedy"),
    [
        ([STATE_NODE], 2, "'rsp' needs the parameter 'robot_description'", "robot.urdf"),
        (
            [PARAM.replace("description", "descripton"), STATE_NODE],
            3,
            "'rsp' needs",
            "'robot_descripton'",
        ),
        (
            [PARAM, SPAWN.format("my_robot")],
            3,
            "'spawn' needs the parameter 'my_robot'",
            "my_robot",
        ),
        (
            ['<node name="n" pkg="a" type="b">', PARAM, "</node>", STATE_NODE],
            5,
            "'rsp' needs",
            "robot_description",
        ),
        (
            ['<include file="$(find gazebo_ros)/launch/empty_world.launch"/>', STATE_NODE],
            3,
            "'rsp' needs",
            "robot.urdf",
        ),
    ],
)
def test_a_description_that_is_not_there(told, inside, line, what, remedy):
    (one,) = told(ROBOT, "LCH-E03", launch=launch(*inside))
    assert (one.severity, one.file, one.span.line) == (Severity.ERROR, "robot.launch", line)
    assert what in one.what
    assert remedy in one.remedy


def test_another_robot_is_loaded(told):
    (one,) = told(ROBOT, "LCH-I15", launch=launch(PARAM.replace("robot.urdf", "robot_2.urdf")))
    assert (one.severity, one.span.line) == (Severity.NOTE, 2)
    assert "'robot_2.urdf', not 'robot.urdf'" in one.what


@pytest.mark.parametrize(
    ("command", "severity", "what"),
    [
        ("$(find xacro)/xacro.py robot.xacro", Severity.ERROR, "'xacro.py' is gone"),
        ("python make.py", Severity.WARNING, "'python' is neither cat nor xacro"),
    ],
)
def test_commands_that_are_not_run(told, command, severity, what):
    text = launch(f'<param name="robot_description" command="{command}"/>')
    (one,) = told(ROBOT, "LCH-E02", launch=text)
    assert (one.severity, one.span.line) == (severity, 2)
    assert what in one.what


def test_faults_of_xml_are_told_with_their_place(told):
    text = launch('<rosparam file="a.yaml">', 'command="load"/>')
    (one,) = told(ROBOT, "LCH-E04", launch=text)
    assert (one.severity, one.file) == (Severity.ERROR, "robot.launch")
    assert one.span.line in (2, 3, 4)
    assert told(ROBOT, "LCH-E04", launch=launch(PARAM)) == []


def test_two_publishers_of_joint_states(told):
    node = '<node name="jsp" pkg="joint_state_publisher" type="joint_state_publisher"/>'
    text = launch(PARAM, SPAWN.format("robot_description"), node)
    (one,) = told(STATES, "CTL-W07", launch=text)
    assert (one.severity, one.file, one.span.line) == (Severity.WARNING, "robot.launch", 4)
    assert one.related[0].file == "robot.urdf"
    assert told(STATES, "CTL-W07", launch=launch(PARAM, node)) == []
    assert told(ROBOT, "CTL-W07", launch=text) == []
    yaml = "states:\n  type: joint_state_controller/JointStateController\n"
    (one,) = told(ROBOT, "CTL-W07", launch=text, yaml=yaml)
    assert one.related[0].file == "controllers.yaml"


def test_anything_may_stand_in_a_launch_file(told):
    for text in (
        "",
        "<launch",
        "<launch><node/><param/><node args=\"-z '\" type='spawn_model'/></launch>",
        "\0",
    ):
        told(ROBOT, launch=text)
