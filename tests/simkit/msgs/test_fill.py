"""Messages from plain data, as rostopic pub fills them."""

from __future__ import annotations

import pytest
import yaml

from simkit.msgs import Duration, MessageError, Time, field_paths, fill_message, message_class

Twist = message_class("geometry_msgs/Twist")
Point = message_class("geometry_msgs/Point")
PoseStamped = message_class("geometry_msgs/PoseStamped")
Trajectory = message_class("trajectory_msgs/JointTrajectory")
Marker = message_class("visualization_msgs/Marker")
NOW = Time(1600088400)


def filled(made, text, **options):
    return fill_message(made, yaml.safe_load(text), **options)


def test_fields_by_name():
    twist = filled(Twist, "{linear: {x: 0.5}, angular: {z: 1}}")
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (0.5, 0.0, 1)


def test_fields_by_position():
    assert filled(Twist, "[[1, 0, 0], [0, 0, 2]]").angular.z == 2
    assert filled(Twist, "[[1, 0, 0], {z: 2}]").angular.z == 2
    assert filled(Point, "[{x: 1}]") == Point(x=1)


def test_one_value_for_a_message_of_one_field():
    assert filled(message_class("std_msgs/String"), "hello").data == "hello"
    assert filled(message_class("std_msgs/Float64"), "1.5").data == 1.5


def test_nothing_gives_the_defaults():
    for text in ("", "{}", "~"):
        assert filled(Twist, text) == Twist()
    assert filled(message_class("std_msgs/Empty"), "") == message_class("std_msgs/Empty")()


def test_arrays_of_messages():
    text = "{joint_names: [a], points: [{positions: [0.1], time_from_start: [1.0, 0.0]}]}"
    trajectory = filled(Trajectory, text)
    assert trajectory.points[0].positions == [0.1]
    assert Trajectory.from_bytes(trajectory.to_bytes()).points[0].time_from_start == Duration(1)


@pytest.mark.parametrize(
    ("text", "duration"),
    [
        ("[1, 5]", Duration(1, 5)),
        ("[1.0, 0.0]", Duration(1)),
        ("{secs: 1}", Duration(1)),
        ("{secs: 1.0}", Duration(1)),
        ("{secs: -1, nsecs: 5}", Duration(-1, 5)),
        ("[0, 2000000000]", Duration(2)),
        ("1500000000", Duration(1.5)),
    ],
)
def test_forms_of_a_duration(text, duration):
    message = filled(Marker, f"{{lifetime: {text}}}")
    assert message.lifetime == duration
    assert Marker.from_bytes(message.to_bytes()).lifetime == duration


def test_words():
    pose = filled(PoseStamped, "{header: auto}", now=NOW)
    assert pose.header.stamp == NOW
    pose = filled(PoseStamped, "{header: {stamp: now, frame_id: map}}", now=NOW)
    assert (pose.header.stamp, pose.header.frame_id) == (NOW, "map")
    assert pose.header.stamp is not NOW
    with pytest.raises(MessageError, match=r"No key named \[soon\].*keys: auto, now"):
        filled(PoseStamped, "{header: {stamp: soon}}", now=NOW)
    with pytest.raises(MessageError, match=r"No key named \[auto\]"):
        filled(PoseStamped, "{header: auto}")


@pytest.mark.parametrize(
    ("made", "text", "error"),
    [
        (Twist, "{liner: {x: 1}}", r"No field name \[liner\]; did you mean linear\?"),
        (Twist, "{linear: {w: 1}}", r"No field name \[linear.w\]; Fields: x, y, z"),
        (Twist, "{linear: {x: 1,5}}", r"\[linear.5\]; .* write a decimal point, 1.5"),
        (Trajectory, "{points: [{pos: [1]}]}", r"No field name \[points\[\]\.pos\]"),
        (
            Twist,
            "[[1, 0], [0, 0, 2]]",
            r"Not enough arguments:\n \* Given: \[1, 0\]\n \* Expected: ",
        ),
        (Twist, "[1, 2, 3]", "Too many arguments"),
        (Twist, "{linear: 5}", r"invalid msg_args type: 5; field \[linear\]"),
        (Trajectory, "{points: 5}", r"Field \[points\] must be a list or tuple instead of: int"),
        (Trajectory, "{points: [5]}", r"invalid msg_args type: 5; field \[points\[\]\]"),
        (Marker, "{lifetime: 1.5}", r"invalid msg_args type: 1.5; field \[lifetime\]"),
        (
            Marker,
            "{lifetime: [1.5, 0]}",
            r"Field \[lifetime.secs\] must be a whole number, not 1.5",
        ),
        (Marker, "{lifetime: [.inf, 0]}", "must be a whole number"),
        (Marker, "{lifetime: [a, 0]}", "must be a whole number"),
        (Marker, "{lifetime: [1]}", "Not enough arguments"),
        (Marker, "{lifetime: {sec: 1}}", r"No field name \[lifetime.sec\]; did you mean secs"),
        (PoseStamped, "{header: {stamp: [-1, 0]}}", "time values must be positive"),
        (
            message_class("sensor_msgs/Imu"),
            "{orientation_covariance: [1]}",
            "has incorrect number of elements: 1 != 9",
        ),
    ],
)
def test_errors(made, text, error):
    with pytest.raises(MessageError, match=error):
        filled(made, text)


def test_an_empty_key_is_an_empty_string():
    assert filled(message_class("std_msgs/Header"), "{frame_id: }").frame_id == ""


def test_messages_are_taken_as_they_are():
    assert (
        fill_message(Twist, {"linear": message_class("geometry_msgs/Vector3")(1, 2, 3)}).linear.z
        == 3
    )


def test_field_paths():
    assert field_paths(Twist()) == [f"{a}.{b}" for a in ("linear", "angular") for b in "xyz"]
    assert field_paths(PoseStamped())[:3] == ["header.seq", "header.stamp", "header.frame_id"]
