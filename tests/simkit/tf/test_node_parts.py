"""Listener, broadcasters and feed on a real graph in this process."""

from __future__ import annotations

import pytest

from simkit.graph import Executor, Graph
from simkit.msgs import Time, message_class
from simkit.tf import (
    Buffer,
    StaticTransformBroadcaster,
    TransformBroadcaster,
    TransformFeed,
    TransformListener,
)

START = 1_600_088_400_000_000_000


class Bench:
    def __init__(self):
        self.executor = Executor(START)
        self.graph = Graph(self.executor)

    def node(self, name):
        return self.graph.create_node(name)

    def run(self, seconds=0.1):
        self.executor.run_to(self.executor.now_ns + round(seconds * 1e9))

    @property
    def warnings(self):
        return [record.text for record in self.graph.records if record.level.name == "WARN"]


@pytest.fixture
def bench():
    return Bench()


def test_what_is_broadcast_is_heard(bench, stamped):
    buffer = Buffer()
    TransformListener(bench.node("/listener"), buffer)
    broadcaster = TransformBroadcaster(bench.node("/turtle_broadcaster"))
    broadcaster.send_transform(stamped("world", "turtle1", 5.0, (1, 2, 3)))
    broadcaster.send_transform([stamped("world", "a", 5.0), stamped("world", "b", 5.0)])
    bench.run()
    assert buffer.lookup_transform("world", "turtle1").transform.translation.x == 1.0
    assert buffer._getFrameStrings() == ["turtle1", "world", "a", "b"]
    assert "broadcaster: '/turtle_broadcaster'" in buffer.all_frames_as_yaml()


def test_a_later_listener_hears_all_static_frames(bench, stamped):
    broadcaster = StaticTransformBroadcaster(bench.node("/static"))
    broadcaster.send_transform(stamped("world", "a", 5.0, (1, 0, 0)))
    broadcaster.send_transform([stamped("world", "b", 5.0), stamped("b", "c", 5.0)])
    broadcaster.send_transform(stamped("world", "a", 6.0, (2, 0, 0)))
    bench.run()
    buffer = Buffer()
    TransformListener(bench.node("/late"), buffer)
    bench.run()
    assert buffer.lookup_transform("a", "c", Time(999)).transform.translation.x == -2.0


def test_a_listener_can_stop(bench, stamped):
    buffer = Buffer()
    listener = TransformListener(bench.node("/listener"), buffer)
    listener.unregister()
    TransformBroadcaster(bench.node("/b")).send_transform(stamped("world", "a", 5.0))
    bench.run()
    assert buffer._getFrameStrings() == []


def test_faults_are_logged_with_advice(bench, stamped):
    TransformListener(bench.node("/listener"), Buffer())
    broadcaster = TransformBroadcaster(bench.node("/b"))
    broadcaster.send_transform(stamped("world", "a", 5.0, q=(0, 0, 1.57, 0)))
    bench.run()
    assert bench.warnings == [
        'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "a" from authority "/b" '
        "because of an invalid quaternion in the transform (0.000000 0.000000 1.570000 0.000000)",
        'The rotation of "a" has the norm 1.57 instead of 1. If these are angles, use '
        "quaternion_from_euler(roll, pitch, yaw), which gives (x, y, z, w).",
    ]


def test_a_fault_of_every_message_is_told_now_and_then(bench, stamped):
    TransformListener(bench.node("/listener"), Buffer())
    broadcaster = TransformBroadcaster(bench.node("/b"))
    for _ in range(101):
        broadcaster.send_transform(stamped("world", "a", 5.0))
    bench.run()
    text = (
        "TF_REPEATED_DATA ignoring data with redundant timestamp for frame a (parent world) "
        "at time 5.000000 according to authority /b"
    )
    assert bench.warnings == [text, text + " (10 times so far)", text + " (100 times so far)"]


def test_rivals_are_told(bench, stamped):
    TransformListener(bench.node("/listener"), Buffer())
    a, b = (TransformBroadcaster(bench.node(name)) for name in ("/a", "/b"))
    for t in range(1, 5):
        a.send_transform(stamped("turtle1", "carrot1", t))
        b.send_transform(stamped("world", "carrot1", t + 0.5))
    bench.run()
    (warning,) = bench.warnings
    assert "carrot1" in warning
    assert "/a (parent turtle1) and /b (parent world)" in warning


@pytest.fixture
def clock():
    return {"now": 100.0}


@pytest.fixture
def feed(clock):
    buffer, warnings = Buffer(), []
    feed = TransformFeed(buffer, now_ns=lambda: clock["now"] * 10**9, warn=warnings.append)
    return feed, buffer, warnings


def tf_message(*transforms):
    return message_class("tf2_msgs/TFMessage")(list(transforms))


def test_a_jump_back_in_time_clears(feed, clock, stamped):
    feed, buffer, warnings = feed
    feed.on_transforms(tf_message(stamped("foo", "bar", 100.0)))
    feed.on_transforms(tf_message(stamped("foo", "bar", 102.0)))
    assert buffer.can_transform("foo", "bar", Time(101))
    clock["now"] = 90.0
    feed.on_transforms(tf_message(stamped("foo", "baz", 100.0)))
    assert not buffer.can_transform("foo", "bar", Time(101))
    assert warnings == ["Detected jump back in time of 10.000000s. Clearing TF buffer."]


def test_warnings_of_questions_are_passed_on(feed, stamped):
    feed, buffer, warnings = feed
    feed.on_transforms(tf_message(stamped("w", "a")))
    buffer.can_transform("/a", "b")
    assert len(warnings) == 1


def test_a_message_without_header_has_tfs_default_authority(feed, stamped):
    feed, buffer, _ = feed
    feed.on_static_transforms(tf_message(stamped("w", "a")))
    assert "broadcaster: 'default_authority'" in buffer.all_frames_as_yaml()
