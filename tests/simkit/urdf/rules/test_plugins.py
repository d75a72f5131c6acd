"""Plugins: which one, where, with which parameters, for which joints and links."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity
from simkit.plugins import plugins
from simkit.plugins.registry import NOT_HERE

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
ROBOT = f"""<link name="base_link">{MASS}</link><link name="left_wheel">{MASS}</link>
<link name="right_wheel">{MASS}</link><link name="mast"/>
<joint name="left" type="continuous"><parent link="base_link"/><child link="left_wheel"/><axis xyz="0 1 0"/></joint>
<joint name="right" type="continuous"><parent link="base_link"/><child link="right_wheel"/><axis xyz="0 1 0"/></joint>
<joint name="stiff" type="fixed"><parent link="base_link"/><child link="mast"/></joint>
"""
DRIVE = """<leftJoint>left</leftJoint>
<rightJoint>right</rightJoint>
<robotBaseFrame>base_link</robotBaseFrame>"""


def model(filename, inside=""):
    """A robot with a plugin on line 7, and what is in it from line 8 on."""
    return ROBOT + f'<gazebo><plugin name="p" filename="{filename}">\n{inside}\n</plugin></gazebo>'


def sensor(filename, inside="", kind="ray"):
    return ROBOT + (
        f'<gazebo reference="base_link"><sensor type="{kind}" name="s"><ray><scan><horizontal><samples>3</samples>'
        f'</horizontal></scan></ray><plugin name="p" filename="{filename}">\n{inside}\n</plugin></sensor></gazebo>'
    )


def diff(inside=DRIVE):
    return model("libgazebo_ros_diff_drive.so", inside)


@pytest.mark.parametrize(
    ("filename", "severity", "words"),
    [
        ("libgazebo_ros_difdrive.so", Severity.WARNING, "'libgazebo_ros_diff_drive.so'"),
        ("gazebo_ros_control", Severity.WARNING, "'libgazebo_ros_control.so'"),
        (
            "libgazebo_ros_joint_state_publishr.so",
            Severity.WARNING,
            "'libgazebo_ros_joint_state_publisher.so'",
        ),
        ("libgazebo_ros_camera.so", Severity.NOTE, "'gazebo_ros_diff_drive'"),
        ("libmy_own_plugin.so", Severity.NOTE, "simkit has"),
        ("gz-sim-diff-drive-system", Severity.NOTE, "In ROS 1 take"),
        ("libgazebo_ros2_control.so", Severity.NOTE, "In ROS 1 take"),
    ],
)
def test_plugins_that_simkit_does_not_have(told, filename, severity, words):
    (one,) = told(model(filename), "GZ-E08")
    assert (one.severity, one.span.line) == (severity, 7)
    assert one.source[one.span.column - 1 :].startswith(filename)
    assert words in one.remedy


def test_a_plugin_without_filename_is_an_error(told):
    (one,) = told(ROBOT + '<gazebo><plugin name="p"/></gazebo>', "GZ-E08")
    assert one.severity is Severity.ERROR


@pytest.mark.parametrize("filename", plugins())
def test_plugins_of_the_table_are_known_where_they_belong(told, filename):
    kind = plugins()[filename].sensor
    text = model(filename) if kind is None else sensor(filename, kind=kind)
    assert told(text, "GZ-E08") == []
    assert told(text, "GZ-E11") == []
    wrong = sensor(filename) if kind is None else model(filename)
    (one,) = told(wrong, "GZ-E11")
    assert one.severity is Severity.ERROR
    assert ("without reference" if kind is None else f'<sensor type="{kind}">') in one.remedy


def test_what_a_plugin_does_not_read_is_said_once():
    for filename, plugin in plugins().items():
        words = [*plugin.tags, *plugin.spellings, *plugin.ignored, *plugin.silent]
        assert len(set(words)) == len(words), filename
    assert not NOT_HERE & {*plugins()}


def test_a_drive_in_the_block_of_a_link_does_not_run(told):
    text = diff().replace("<gazebo>", '<gazebo reference="base_link">')
    (one,) = told(text, "GZ-E11")
    assert 'stands in a <gazebo reference="base_link">' in one.what
    assert one.remedy == "It belongs in a <gazebo> without reference."


@pytest.mark.parametrize(
    ("wrong", "severity", "remedy"),
    [
        ("<torque>0.1</torque>", Severity.WARNING, "<wheelTorque>0.1</wheelTorque>"),
        (
            "<wheel_separation>0.3</wheel_separation>",
            Severity.WARNING,
            "<wheelSeparation>0.3</wheelSeparation>",
        ),
        (
            "<wheelSeperation>0.3</wheelSeperation>",
            Severity.WARNING,
            "<wheelSeparation>0.3</wheelSeparation>",
        ),
        ("<alwaysOn>true</alwaysOn>", Severity.NOTE, "Leave it out."),
        ("<zebra>1</zebra>", Severity.NOTE, "Leave it out."),
    ],
)
def test_parameters_that_are_not_read(told, wrong, severity, remedy):
    (one,) = told(diff(f"{DRIVE}\n{wrong}"), "GZ-W10")
    assert (one.severity, one.span.line) == (severity, 11)
    assert remedy in one.remedy


@pytest.mark.parametrize(
    ("wrong", "what"),
    [
        ("<wheelDiameter>0,2</wheelDiameter>", "<wheelDiameter> is not a number: '0,2'"),
        ("<wheelDiameter>-1</wheelDiameter>", "<wheelDiameter> must be more than 0"),
        ("<updateRate>-1</updateRate>", "<updateRate> is negative"),
        ("<publishTf>on</publishTf>", "<publishTf> is neither true nor false: 'on'"),
    ],
)
def test_values_that_a_plugin_cannot_use(told, wrong, what):
    (one,) = told(diff(f"{DRIVE}\n{wrong}"), "GZ-W10")
    assert (one.severity, one.span.line) == (Severity.WARNING, 11)
    assert what in one.what


def test_parameters_that_are_read(told):
    good = "<updateRate>0</updateRate><publishTf>True</publishTf><wheelTorque> 5.0 </wheelTorque>"
    assert told(diff(DRIVE + good), "GZ-W10") == []


def test_a_parameter_that_must_be_there(told):
    (one,) = told(model("libgazebo_ros_joint_state_publisher.so"), "GZ-W10")
    assert one.remedy == "Add <jointName>left, right</jointName>."


@pytest.mark.parametrize(
    ("inside", "severity", "what", "remedy"),
    [
        (
            DRIVE.replace(">left<", ">lef<"),
            Severity.ERROR,
            "<leftJoint> names 'lef', and there is no such joint",
            "'left'",
        ),
        (
            DRIVE.replace(">left<", ">stiff<"),
            Severity.ERROR,
            "<leftJoint> names 'stiff', which is a fixed joint",
            "'left', 'right'",
        ),
        (
            DRIVE.replace("<leftJoint>left</leftJoint>", ""),
            Severity.ERROR,
            "<leftJoint> is missing, so the plugin looks for a joint 'left_joint'",
            "'left'",
        ),
        (
            DRIVE.replace(">base_link<", ">base<"),
            Severity.WARNING,
            "<robotBaseFrame> names 'base', and no link has that name",
            "'base_link'",
        ),
    ],
)
def test_names_of_nothing(told, inside, severity, what, remedy):
    (one,) = told(diff(inside), "GZ-E09")
    assert one.severity is severity
    assert what in one.what
    assert remedy in one.remedy


def test_frames_that_a_plugin_takes_where_none_is_given(told):
    base = "<robotBaseFrame>base_link</robotBaseFrame>"
    (one,) = told(diff(DRIVE.replace(base, "")), "GZ-E09")
    assert one.severity is Severity.WARNING
    assert "so the plugin takes 'base_footprint', and no link has that name" in one.what
    (one,) = told(sensor("libgazebo_ros_laser.so", "<topicName>scan</topicName>"), "GZ-E09")
    assert "takes '/world'" in one.what


def test_names_that_are_there(told):
    assert told(diff(), "GZ-E09") == []
    assert told(diff(DRIVE.replace(">base_link<", ">/base_link<")), "GZ-E09") == []
    laser = "<topicName>scan</topicName><frameName>mast</frameName>"
    assert told(sensor("libgazebo_ros_laser.so", laser), "GZ-E09") == []


def test_a_body_that_gazebo_melts_into_another(told):
    inside = "<bodyName>mast</bodyName><topicName>pose</topicName>"
    (one,) = told(model("libgazebo_ros_p3d.so", inside), "GZ-E09")
    assert one.severity is Severity.NOTE
    assert "one body with 'base_link'" in one.gazebo
    (one,) = told(model("libgazebo_ros_p3d.so", inside.replace("mast", "mst")), "GZ-E09")
    assert one.severity is Severity.ERROR


def test_what_is_lost_anyway_is_not_told_twice(told):
    text = sensor("libgazebo_ros_laser.so", "<frameName>eye</frameName>")
    lost = text.replace('<gazebo reference="base_link">', '<gazebo reference="eye">')
    assert [one.rule for one in told(lost) if one.rule.startswith("GZ-E")] == ["GZ-E01"]
