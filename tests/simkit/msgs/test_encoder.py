"""Encoding: what is sent, and what is refused with the name of the field."""

from __future__ import annotations

import re

import numpy as np
import pytest

from simkit.msgs import Duration, Message, SerializationError, Time, message_class


def make(made: str, /, **fields: object) -> Message:
    return message_class(made)(**fields)


def trajectory(**fields: object) -> Message:
    point = make("trajectory_msgs/JointTrajectoryPoint", **fields)
    return make("trajectory_msgs/JointTrajectory", points=[point])


def test_known_bytes():
    assert make("std_msgs/String", data="é").to_bytes() == b"\2\0\0\0\xc3\xa9"
    assert make("turtlesim/Color", r=1, g=2, b=255).to_bytes() == b"\1\2\xff"
    assert make("std_msgs/Duration", data=Duration(-1, 5)).to_bytes() == b"\xff\xff\xff\xff\5\0\0\0"
    image = make("sensor_msgs/CompressedImage", format="p", data=[1, 2])
    assert image.to_bytes() == bytes(16) + b"\1\0\0\0p\2\0\0\0\1\2"


def test_every_type_comes_back_as_it_was(all_classes, random_message):
    for made in all_classes:
        for seed in range(3):
            message = random_message(made, seed)
            data = message.to_bytes()
            again = made.from_bytes(data)
            assert again == message
            assert again.to_bytes() == data


@pytest.mark.parametrize("values", [(1.0, 2), [1, 2.0], np.array([1.0, 2.0]), range(1, 3)])
def test_arrays_of_numbers_may_be_any_sequence(values):
    expected = make("std_msgs/Float64MultiArray", data=[1.0, 2.0]).to_bytes()
    assert make("std_msgs/Float64MultiArray", data=values).to_bytes() == expected


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int64])
def test_arrays_of_numpy_are_sent_as_lists_are(kind):
    scan = message_class("sensor_msgs/LaserScan")
    values = np.array([1, 3, 2, 7], dtype=kind)
    for given in (values, values[::2], values[:0]):
        assert scan(ranges=given).to_bytes() == scan(ranges=given.tolist()).to_bytes()


@pytest.mark.parametrize("data", [b"\1\2", bytearray(b"\1\2"), [1, 2], (1, 2), memoryview(b"\1\2")])
def test_octets_may_be_bytes_or_a_list(data):
    assert make("std_msgs/UInt8MultiArray", data=data).to_bytes().endswith(b"\2\0\0\0\1\2")


def test_numpy_numbers_can_be_sent():
    assert make("std_msgs/Int32", data=np.int64(7)).to_bytes() == b"\7\0\0\0"
    assert make("std_msgs/Float32", data=np.float64(0)).to_bytes() == bytes(4)


def test_a_message_with_the_right_fields_will_do():
    point = make("geometry_msgs/Point", x=1, y=2, z=3)
    transform = make("geometry_msgs/Transform", translation=point)
    assert (
        message_class("geometry_msgs/Transform").from_bytes(transform.to_bytes()).translation.z == 3
    )


COMPLAINTS = [
    ("std_msgs/Float64", "1.5", "field data must be float type, not str: '1.5'"),
    ("std_msgs/Float64", None, ""),
    ("std_msgs/Float64", [1.0], "field data must be float type, not list"),
    ("std_msgs/Float32", 1e300, "field data exceeds specified width [float32]"),
    ("std_msgs/Int8", 1.0, "field data must be an integer type, not float: 1.0"),
    ("std_msgs/Int8", 128, "field data exceeds specified width [int8]"),
    ("std_msgs/UInt8", -1, "field data must be unsigned integer type"),
    ("std_msgs/UInt8", 256, "field data exceeds specified width [uint8]"),
    ("std_msgs/UInt64", 2**64, "field data exceeds specified width [uint64]"),
    ("std_msgs/Bool", "false", "field data is not a bool, not str: 'false'"),
    ("std_msgs/String", 5, "field data must be of type str, not int: 5"),
    ("std_msgs/String", b"x", "field data must be of type str, not bytes: b'x'"),
    ("std_msgs/String", "\ud800", "field data cannot be written as UTF-8"),
    ("std_msgs/Time", 1.5, "field data must be of type Time, not float: 1.5"),
    ("std_msgs/Duration", 2, "field data must be of type Duration, not int: 2"),
    ("std_msgs/Time", Duration(-1), "field data.secs must be unsigned integer type"),
    ("std_msgs/Header", None, ""),
    ("std_msgs/Float64MultiArray", 1.5, "field data must be a list or tuple type"),
    ("std_msgs/Float64MultiArray", "ab", "field data must be a list or tuple type"),
    ("std_msgs/Float64MultiArray", [1, "b"], "field data[] must be float type, not str: 'b'"),
    ("std_msgs/Int16MultiArray", [70000], "field data[] exceeds specified width [int16]"),
    ("std_msgs/UInt8MultiArray", "ab", "field data must be a list or tuple type"),
    ("std_msgs/UInt8MultiArray", [256], "field data[] exceeds specified width [uint8]"),
    ("std_msgs/UInt8MultiArray", 5, "field data must be a list or tuple type"),
    ("std_msgs/UInt8MultiArray", np.zeros(2), "field data must be bytes, a list or a tuple"),
]


@pytest.mark.parametrize(("name", "value", "text"), [c for c in COMPLAINTS if c[2]])
def test_a_wrong_value_is_named(name, value, text):
    message = make(name, data=value)
    with pytest.raises(SerializationError, match="^" + re.escape(text)):
        message.to_bytes()


def test_a_wrong_value_is_named_at_any_depth():
    with pytest.raises(
        SerializationError, match=r"field points\[\]\.positions\[\] must be float type"
    ):
        trajectory(positions=["a"]).to_bytes()
    duration = Duration()
    duration.secs = 1.0
    with pytest.raises(
        SerializationError, match=r"field points\[\]\.time_from_start\.secs must be an integer type"
    ):
        trajectory(time_from_start=duration).to_bytes()
    twist = make("geometry_msgs/Twist")
    twist.linear.x = "fast"
    with pytest.raises(SerializationError, match=r"field linear\.x must be float type"):
        twist.to_bytes()


def test_none_is_no_value():
    header = make("std_msgs/Header")
    for name, wanted in (("seq", "unsigned integer"), ("stamp", "Time"), ("frame_id", "str")):
        setattr(header, name, None)
        with pytest.raises(SerializationError, match=f"field {name} must be .*{wanted}.*NoneType"):
            header.to_bytes()
        setattr(header, name, getattr(make("std_msgs/Header"), name))


def test_a_deleted_field_is_named():
    message = make("std_msgs/Int32")
    del message.data
    with pytest.raises(SerializationError, match="field data must be an integer type"):
        message.to_bytes()


def test_arrays_of_fixed_length():
    imu = make("sensor_msgs/Imu", orientation_covariance=[0.0] * 8)
    with pytest.raises(
        SerializationError, match="field orientation_covariance must have 9 elements, not 8"
    ):
        imu.to_bytes()


def test_a_string_is_no_list_of_strings():
    with pytest.raises(
        SerializationError, match="field name must be a list or tuple type, not str"
    ):
        make("sensor_msgs/JointState", name="joint1").to_bytes()
    with pytest.raises(SerializationError, match=r"field name\[\] must be of type str, not int: 3"):
        make("sensor_msgs/JointState", name=["a", 3]).to_bytes()


def test_nested_messages_of_the_wrong_type():
    with pytest.raises(
        SerializationError, match=r"translation must be of type \[geometry_msgs/Vec"
    ):
        make("geometry_msgs/Transform", translation=(1, 2, 3)).to_bytes()
    with pytest.raises(
        SerializationError, match=r"transforms\[\] must be of .*not geometry_msgs/Tran"
    ):
        message_class("tf2_msgs/TFMessage")([make("geometry_msgs/Transform")]).to_bytes()
    with pytest.raises(SerializationError, match="field header must be a Header, not Time"):
        make("sensor_msgs/JointState", header=Time()).to_bytes()
