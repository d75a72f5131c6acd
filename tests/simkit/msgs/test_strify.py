"""Messages print as `rostopic echo` shows them."""

from __future__ import annotations

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from simkit import UnknownNameError
from simkit.msgs import Duration, Time, message_class, strify_message
from simkit.msgs.strify import message_text, service_text

String = message_class("std_msgs/String")
JointState = message_class("sensor_msgs/JointState")

TWIST = """\
linear: 
  x: 0.5
  y: 0.0
  z: 0.0
angular: 
  x: 0.0
  y: 0.0
  z: -1"""  # noqa: W291

JOINTS = """\
header: 
  seq: 3
  stamp: 
    secs: 1600088400
    nsecs:       250
  frame_id: ''
name: 
  - hip
  - 'true'
position: [1.0, -0.5]
velocity: []
effort: []"""  # noqa: W291

TRAJECTORY = """\
joint_names: 
  - hip
points: 
  - 
    positions: [1.0]
    velocities: []
    accelerations: []
    effort: []
    time_from_start: 
      secs: -1
      nsecs: 500000000"""  # noqa: W291


def test_nested_messages():
    twist = message_class("geometry_msgs/Twist")()
    twist.linear.x = 0.5
    twist.angular.z = -1
    assert str(twist) == repr(twist) == TWIST


def test_times_and_arrays():
    message = JointState(name=["hip", "true"], position=(1.0, -0.5))
    message.header.seq = 3
    message.header.stamp = Time(1600088400, 250)
    assert str(message) == JOINTS


def test_arrays_of_messages():
    made = message_class("trajectory_msgs/JointTrajectory")
    point = message_class("trajectory_msgs/JointTrajectoryPoint")
    message = made(
        joint_names=["hip"], points=[point(positions=[1.0], time_from_start=Duration(-0.5))]
    )
    assert str(message).split("\n", 6)[6] == TRAJECTORY


def test_single_values():
    assert str(String("hello")) == 'data: "hello"'
    assert str(String("")) == "data: ''"
    assert str(message_class("std_msgs/Bool")(True)) == "data: True"
    assert str(message_class("std_msgs/Empty")()) == ""
    assert strify_message(Time(1, 2)) == "\nsecs: 1\nnsecs:         2"
    assert strify_message([True, False]) == "[True, False]"


def test_octets_print_as_numbers():
    text = str(message_class("std_msgs/UInt8MultiArray")(data=b"\1\xff"))
    assert text.endswith("data: [1, 255]")


@pytest.mark.parametrize("text", ['say "hi"', "back\\slash", "two\nlines", "é", "x " * 60, "it's"])
def test_strings_are_quoted_as_yaml_does(text):
    expected = yaml.dump(text, default_style='"').rstrip("\n")
    assert str(String(text)) == f"data: {expected}"


@given(st.text(st.characters(codec="ascii"), min_size=1, max_size=90))
def test_quoting_agrees_with_yaml(text):
    assert strify_message(text) == yaml.dump(text, default_style='"').rstrip("\n")


@given(st.lists(st.text("abzAZ09_/.- 'eE:#yno~", max_size=12), min_size=1, max_size=3))
def test_lists_of_strings_agree_with_yaml(texts):
    assert strify_message(texts).split("\n")[1:] == yaml.dump(texts).rstrip("\n").split("\n")


# -- definition_text


def test_nested_messages_are_indented():
    assert message_text("geometry_msgs/PointStamped") == (
        "std_msgs/Header header\n"
        "  uint32 seq\n"
        "  time stamp\n"
        "  string frame_id\n"
        "geometry_msgs/Point point\n"
        "  float64 x\n"
        "  float64 y\n"
        "  float64 z\n"
    )


def test_constants_come_first():
    assert message_text("rosgraph_msgs/Log").startswith("byte DEBUG=1\nbyte INFO=2\n")


def test_a_service_has_two_parts():
    assert service_text("turtlesim/Kill") == "string name\n---\n"


def test_unknown_types():
    with pytest.raises(UnknownNameError):
        message_text("geometry_msgs/Twst")
