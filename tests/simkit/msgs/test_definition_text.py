from __future__ import annotations

import pytest

from simkit import UnknownNameError
from simkit.msgs.definition_text import message_text, service_text


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
