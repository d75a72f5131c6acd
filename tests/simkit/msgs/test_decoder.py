"""Decoding is total: any bytes give a message or a DeserializationError."""

from __future__ import annotations

import random
import struct
import tracemalloc

import pytest

from simkit.msgs import DeserializationError, Duration, Time, message_class

String = message_class("std_msgs/String")
Image = message_class("sensor_msgs/Image")


def mutations(data: bytes, chance: random.Random) -> list[bytes]:
    """Variants of a message: cut, extended, with changed bytes, with a huge length."""
    cut = data[: chance.randrange(len(data) + 1)]
    changed = bytearray(data)
    huge = bytearray(data)
    if data:
        for _ in range(3):
            changed[chance.randrange(len(data))] = chance.randrange(256)
        at = chance.randrange(len(data))
        huge[at : at + 4] = b"\xff\xff\xff\x7f"
    return [cut, data + b"\0", bytes(changed), bytes(huge), chance.randbytes(len(data))]


def test_any_bytes_give_a_message_or_an_error(all_classes, random_message):
    chance = random.Random(1)
    decoded, refused = 0, set()
    for made in all_classes:
        data = random_message(made, 7).to_bytes()
        for variant in (v for _ in range(4) for v in mutations(data, chance)):
            try:
                assert type(made.from_bytes(variant)) is made
                decoded += 1
            except DeserializationError as error:
                refused.add(str(error))
    assert decoded > 500
    assert len(refused) > 500


def test_each_cut_is_an_error(random_message):
    for name in ("nav_msgs/Path", "sensor_msgs/JointState", "visualization_msgs/Marker"):
        made = message_class(name)
        data = random_message(made, 3).to_bytes()
        for end in range(len(data)):
            with pytest.raises(DeserializationError):
                made.from_bytes(data[:end])


@pytest.mark.parametrize(
    "name",
    [
        "std_msgs/String",
        "std_msgs/Float64MultiArray",
        "std_msgs/UInt8MultiArray",
        "sensor_msgs/JointState",
        "tf2_msgs/TFMessage",
        "geometry_msgs/Polygon",
        "gazebo_msgs/ModelStates",
    ],
)
def test_a_lying_length_costs_nothing(name):
    made = message_class(name)
    made.from_bytes(made().to_bytes())
    tracemalloc.start()
    with pytest.raises(DeserializationError):
        made.from_bytes(b"\xff" * 64)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 100_000


def test_what_is_wrong_is_said():
    with pytest.raises(DeserializationError, match="std_msgs/String: 9 bytes expected, 1 are left"):
        String.from_bytes(b"\x09\0\0\0x")
    with pytest.raises(DeserializationError, match="std_msgs/String: 2 bytes are left over"):
        String.from_bytes(bytes(6))


def test_large_messages_need_permission():
    data = Image(data=bytes(17 * 2**20)).to_bytes()
    with pytest.raises(DeserializationError, match="at most 16777216 are accepted"):
        Image.from_bytes(data)
    assert len(Image.from_bytes(data, max_bytes=len(data)).data) == 17 * 2**20


def test_other_buffers():
    assert String.from_bytes(bytearray(b"\1\0\0\0x")) == String("x")
    assert String.from_bytes(memoryview(b"\1\0\0\0x")) == String("x")


def test_types_of_values_are_those_of_genpy():
    made = message_class("sensor_msgs/CameraInfo")
    info = made.from_bytes(made(D=[1.0], distortion_model="m").to_bytes())
    assert info.D == (1.0,)
    assert type(info.K) is tuple
    assert info.roi.do_rectify is False
    image = Image.from_bytes(Image(data=[1, 2]).to_bytes())
    assert image.data == b"\1\2"
    state = message_class("sensor_msgs/JointState")
    assert state.from_bytes(state(name=("a", "b")).to_bytes()).name == ["a", "b"]


def test_text_that_is_not_utf8_is_repaired():
    assert String.from_bytes(b"\3\0\0\0a\xffb").data == "a\ufffdb"


def test_times_are_canonical():
    time = message_class("std_msgs/Time").from_bytes(struct.pack("<II", 1, 3_000_000_001))
    assert time.data == Time(4, 1)
    duration = message_class("std_msgs/Duration").from_bytes(struct.pack("<ii", 1, -1))
    assert (duration.data.secs, duration.data.nsecs) == (0, 999_999_999)
    assert duration.data == Duration(0, 999_999_999)
