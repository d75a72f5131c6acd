from __future__ import annotations

import math
from itertools import pairwise

import pytest

from simkit.msgs import Time, message_class
from simkit.tf.transformations import quaternion_from_euler
from simkit.viz import RvizSettings
from simkit.viz.rviz_tape import rviz_tape
from simkit.viz.stage.camera import on_paper

START = 1_600_088_400


class Tape:
    """A recording that is easy to fill."""

    def __init__(self):
        self.messages = {"/tf": [], "/tf_static": []}

    def say(self, t, parent, child, xyz=(0, 0, 0), yaw=0.0, *, static=False):
        one = message_class("geometry_msgs/TransformStamped")()
        one.header.frame_id, one.child_frame_id = parent, child
        one.header.stamp = Time.from_nsec(round((START + t) * 1e9))
        p, q = one.transform.translation, one.transform.rotation
        p.x, p.y, p.z = map(float, xyz)
        q.x, q.y, q.z, q.w = map(float, quaternion_from_euler(0, 0, yaw))
        message = message_class("tf2_msgs/TFMessage")(transforms=[one])
        self.messages["/tf_static" if static else "/tf"].append((one.header.stamp, message))

    def topics(self):
        return sorted(topic for topic, messages in self.messages.items() if messages)

    def __getitem__(self, topic):
        return self.messages[topic]


@pytest.fixture
def turning():
    """A link that turns for four seconds, one that is fixed, one that joins them late."""
    tape = Tape()
    tape.say(0, "world", "base_link", (1, 0, 0), static=True)
    for k in range(201):
        tape.say(k / 50, "base_link", "torso", (0, 0, 0.05), yaw=k / 25)
        if k >= 100:
            tape.say(k / 50, "torso", "upper_arm", (0, -0.1, 0.45))
    return tape


def taped(tape, robot=None, **settings):
    return rviz_tape(tape, RvizSettings(**settings), robot)


def at(track, time):
    """A track at a time, straight in between."""
    for before, after in pairwise(track):
        if before[0] <= time <= after[0]:
            ratio = (time - before[0]) / (after[0] - before[0]) if after[0] > before[0] else 0.0
            return [b + ratio * (a - b) for b, a in zip(before, after, strict=True)][1:]
    raise AssertionError(f"nothing at {time}")


def test_between_its_rows_a_frame_is_where_it_was(turning):
    tape = taped(turning)
    assert (tape.start_ns, tape.duration) == (START * 10**9, pytest.approx(4.0))
    tracks = {p.name: t.rows for p, t in zip(tape.scene.tf.poses, tape.tracks, strict=True)}
    for k in range(0, 200, 7):
        *place, _, _, z, w = at(tracks["torso"], k / 50)
        assert place == pytest.approx((1, 0, 0.05), abs=1e-3)
        turned = 2 * math.atan2(z, w) - k / 25
        assert math.remainder(turned, 2 * math.pi) == pytest.approx(0, abs=0.02)
    assert len(tracks["base_link"]) == 2
    assert 20 < len(tracks["torso"]) < 100


def test_quaternions_do_not_jump(turning):
    for track in taped(turning).tracks:
        for before, after in pairwise(track.rows):
            assert math.fsum(a * b for a, b in zip(before[4:], after[4:], strict=True)) > 0.9


def test_a_frame_begins_when_it_is_first_heard_of(turning):
    tape = taped(turning)
    begins = {p.name: t.rows[0][0] for p, t in zip(tape.scene.tf.poses, tape.tracks, strict=True)}
    assert begins["torso"] == 0.0
    assert begins["upper_arm"] == pytest.approx(2.0, abs=0.05)


def test_after_a_silence_a_frame_jumps(turning):
    turning.say(9.0, "base_link", "torso", (0, 0, 3))
    tape = taped(turning)
    (torso,) = [
        t.rows for p, t in zip(tape.scene.tf.poses, tape.tracks, strict=True) if p.name == "torso"
    ]
    assert at(torso, 8.5)[2] == pytest.approx(0.05, abs=1e-3)
    assert at(torso, 9.0)[2] == pytest.approx(3)


def test_the_camera_sees_every_moment(turning, arm):
    tape = taped(turning, robot=arm)
    for track in tape.tracks:
        for _, x, y, z, *_ in track.rows:
            column, row = on_paper(tape.scene.stage.camera.seen((x, y, z)), (720, 450))
            assert 0 <= column <= 720
            assert 0 <= row <= 450


def test_seen_from_another_frame(turning):
    tape = taped(turning, fixed_frame="torso")
    tracks = {p.name: t.rows for p, t in zip(tape.scene.tf.poses, tape.tracks, strict=True)}
    assert len(tracks["torso"]) == 2
    assert len(tracks["world"]) > 20


def test_nothing_recorded_and_a_frame_that_is_not_there(turning):
    empty = taped(Tape())
    assert (empty.duration, empty.tracks) == (0.0, ())
    assert empty.scene.tf.error.startswith("No tf data.")
    assert taped(turning, fixed_frame="map").scene.tf.error.startswith("Fixed Frame [map] does not")
