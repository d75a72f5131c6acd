"""The buffer that speaks messages."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from simkit.errors import SimkitError
from simkit.msgs import Duration, Time
from simkit.tf import (
    Buffer,
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)


@pytest.fixture
def buffer(stamped):
    buffer = Buffer()
    for t in (10.0, 11.0):
        buffer.set_transform(stamped("world", "turtle1", t, (t, 2.0, 3.0)), "/broadcaster")
    buffer.set_transform_static(stamped("turtle1", "carrot1", 0.0, (0.0, 2.0, 0.0)))
    return buffer


def test_lookup_gives_a_message(buffer):
    found = buffer.lookup_transform("world", "carrot1", Time(10.5))
    assert found._type == "geometry_msgs/TransformStamped"
    assert (found.header.frame_id, found.child_frame_id) == ("world", "carrot1")
    assert found.header.stamp == Time(10.5)
    p, q = found.transform.translation, found.transform.rotation
    assert (p.x, p.y, p.z) == (10.5, 4.0, 3.0)
    assert (q.x, q.y, q.z, q.w) == (0.0, 0.0, 0.0, 1.0)


def test_time_zero_is_the_latest(buffer):
    assert buffer.lookup_transform("world", "turtle1").header.stamp == Time(11)
    assert buffer.lookup_transform("world", "turtle1", Time(0)).header.stamp == Time(11)
    assert buffer.get_latest_common_time("world", "carrot1") == Time(11)


def test_lookup_full(buffer):
    found = buffer.lookup_transform_full("turtle1", Time(11), "turtle1", Time(10), "world")
    assert found.transform.translation.x == -1.0
    assert found.header.stamp == Time(11)
    assert buffer.can_transform_full("turtle1", Time(11), "turtle1", Time(10), "world")
    assert not buffer.can_transform_full("turtle1", Time(11), "turtle1", Time(9), "world")


def test_can_transform(buffer):
    assert buffer.can_transform("world", "turtle1")
    assert not buffer.can_transform("world", "turtle1", Time(12))
    assert buffer.can_transform_core("world", "nobody", Time(0)) == (
        False,
        "canTransform: source_frame nobody does not exist.",
    )


def test_a_duration_is_a_time_too(buffer):
    assert buffer.lookup_transform("world", "turtle1", Duration(10)).header.stamp == Time(10)
    seconds = SimpleNamespace(to_sec=lambda: 10.25)
    assert buffer.lookup_transform("world", "turtle1", seconds).header.stamp == Time(10.25)


def test_a_bare_number_is_no_time(buffer):
    with pytest.raises(TypeError) as caught:
        buffer.lookup_transform("world", "turtle1", 10.5)
    assert str(caught.value) == "time must have a to_sec method, e.g. rospy.Time or rospy.Duration"
    assert "10.5, a float" in caught.value.__notes__[0]


def test_whole_numbers_in_a_message_become_floats(stamped):
    buffer = Buffer()
    buffer.set_transform(stamped("world", "a", 1.0, (1, 2, 3), (0, 0, 0, 1)))
    translation = buffer.lookup_transform("world", "a").transform.translation
    assert isinstance(translation.x, float)


def test_cache_time(stamped):
    buffer = Buffer(Duration(2))
    for t in (1.0, 2.0, 3.0, 4.0):
        buffer.set_transform(stamped("world", "a", t))
    assert not buffer.can_transform("world", "a", Time(1))
    assert buffer.can_transform("world", "a", Time(2))


def test_warnings_are_told(stamped):
    warnings: list[str] = []
    buffer = Buffer(on_warning=warnings.append)
    assert not buffer.set_transform(stamped("a", "a", 1.0))
    assert warnings[0].startswith("TF_SELF_TRANSFORM")


def test_nobody_need_listen_to_warnings(stamped):
    assert not Buffer().set_transform(stamped("a", "a", 1.0))


def test_the_names_of_tf2s_buffer_core(buffer):
    assert buffer.all_frames_as_string().startswith("Frame turtle1 exists with parent world.")
    assert buffer.all_frames_as_yaml().startswith("turtle1: \n  parent: 'world'\n")
    assert "( 1.000 sec old)" in buffer._allFramesAsDot(Time(12))
    assert buffer._getFrameStrings() == ["turtle1", "world", "carrot1"]
    assert buffer._frameExists("world")
    assert buffer._chain("world", Time(0), "carrot1", Time(0), "world") == [
        "carrot1",
        "turtle1",
        "world",
    ]
    assert buffer.lookup_transform_core("world", "turtle1", Time(10)).header.stamp == Time(10)
    buffer.clear()
    assert buffer.all_frames_as_yaml().startswith("carrot1: ")


def test_exceptions_form_tf2s_family():
    family = (
        LookupException, ConnectivityException, ExtrapolationException, InvalidArgumentException,
        TimeoutException,
    )  # fmt: skip
    for exception in family:
        assert exception.__mro__[1] is TransformException
        assert str(exception("text")) == "text"
        assert exception("text").hint == ""
    assert issubclass(TransformException, SimkitError)
