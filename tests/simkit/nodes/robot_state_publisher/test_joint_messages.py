from __future__ import annotations

import random

from simkit.nodes.robot_state_publisher.joint_messages import (
    MissingJoints,
    PublishGate,
    Throttle,
)

MS = 1_000_000


def paced(period_ns, count, jitter_ns=0):
    """How many of `count` messages with two joints count."""
    gate, rng, counted = PublishGate(20 * MS), random.Random(1), 0
    for number in range(1, count + 1):
        now = 10**18 + number * period_ns
        stamp = now - rng.randint(0, jitter_ns)
        counted += gate.counts(["a", "b"], stamp_ns=stamp, now_ns=now)
    return counted


def test_the_pace_is_that_of_the_original():
    assert paced(10**9 // 30, 300) == 300
    assert paced(10**9 // 60, 600) == 300
    assert paced(10 * MS, 1000) == 500
    # Stamps that jitter by a tenth of a millisecond: every second message or every third one.
    assert 380 <= paced(10 * MS, 1000, jitter_ns=MS // 10) <= 420


def test_the_joint_that_has_waited_longest_decides():
    gate = PublishGate(20 * MS)
    now = 10**18
    assert gate.counts(["a"], stamp_ns=now, now_ns=now)
    assert not gate.counts(["a"], stamp_ns=now + 19 * MS, now_ns=now + 19 * MS)
    assert gate.counts(["a", "b"], stamp_ns=now + 19 * MS, now_ns=now + 19 * MS)
    assert not gate.counts(["a", "b"], stamp_ns=now + 20 * MS, now_ns=now + 20 * MS)
    assert gate.counts(["a", "b"], stamp_ns=now + 39 * MS, now_ns=now + 39 * MS)


def test_no_joint_and_no_stamp_never_count():
    gate = PublishGate(20 * MS)
    assert not gate.counts([], stamp_ns=10**18, now_ns=10**18)
    assert not gate.counts(["a"], stamp_ns=0, now_ns=10**18)


def test_stamps_can_be_ignored():
    gate = PublishGate(20 * MS, ignore_stamps=True)
    assert [gate.counts(["a"], stamp_ns=0, now_ns=10**18) for _ in range(3)] == [True] * 3


def test_after_the_clock_was_set_back_the_next_message_counts():
    gate = PublishGate(20 * MS)
    assert gate.counts(["a"], stamp_ns=10**18, now_ns=10**18)
    assert not gate.counts(["a"], stamp_ns=10**9, now_ns=10**9)
    gate.forget()
    assert gate.counts(["a"], stamp_ns=10**9, now_ns=10**9)


def test_what_is_throttled_is_said_once_in_a_while():
    throttle = Throttle(10)
    seconds = [0, 1, 9.9, 10, 12, 20, 5]
    said = [throttle.permits(round(second * 1e9)) for second in seconds]
    assert said == [True, False, False, True, False, True, True]


def test_who_speaks_and_who_is_missing_decides_what_the_hint_says():
    missing = MissingJoints(["elbow", "hip"])
    assert missing.hint("/joint_states", []) == (
        "hint: nobody publishes /joint_states, so elbow, hip have no position, and no transform: "
        "start joint_state_publisher, or joint_state_publisher_gui for sliders"
    )
    assert missing.hint("/joint_states", ["/me"]) == (
        "hint: /me has not said anything on /joint_states yet, "
        "so elbow, hip have no position, and no transform"
    )
    missing.count_message(stamped=False)
    assert "no time stamp" in missing.hint("/joint_states", ["/me"])
    missing.count_message(stamped=True)
    missing.note_positions(["hip", "other"])
    assert missing.hint("/joint_states", ["/me"]) == (
        "hint: /me on /joint_states gives no position for some joints: "
        "elbow has no position, and no transform"
    )
    missing.note_positions(["elbow"])
    assert missing.hint("/joint_states", []) is None
