from __future__ import annotations

import math

import pytest

from simkit.viz.turtlesim.tape import turtle_tape


def at(rows, time):
    """Values at a time: the row that is not later, and the way to the next."""
    index = max(i for i, row in enumerate(rows) if row[0] <= time)
    before, after = rows[index], rows[min(index + 1, len(rows) - 1)]
    if after[0] == before[0]:
        return before[1:]
    ratio = (time - before[0]) / (after[0] - before[0])
    return tuple(a + ratio * (b - a) for a, b in zip(before[1:], after[1:], strict=True))


def metres(values):
    return ((values[0] - 0.5) / 45, 11.0888889 - (values[1] - 0.5) / 45)


def test_the_motion_is_the_history_with_fewer_rows(window):
    window.drive(1.0, 0.5)
    window.run(20)
    tape = turtle_tape(window.frame)
    (motion,) = tape.motions
    history = window.frame.turtle("turtle1").history
    assert len(history) > 1200
    assert len(motion.rows) < 200
    unwrapped = 0.0
    for before, sample in zip([history[0], *history], history, strict=False):
        unwrapped += math.remainder(sample.pose.theta - before.pose.theta, 2 * math.pi)
        x, y, heading = at(motion.rows, (sample.time_ns - tape.start_ns) / 1e9)
        assert metres((x, y)) == pytest.approx((sample.pose.x, sample.pose.y), abs=0.005)
        assert heading == pytest.approx(math.degrees(unwrapped), abs=1.0)


def test_times_count_from_the_first_update_to_the_last(window):
    window.run(2.0)
    tape = turtle_tape(window.frame)
    assert tape.start_ns == 1_600_088_400_032_000_000
    assert tape.duration == pytest.approx(2.0 - 0.032, abs=0.016)
    assert tape.motions[0].until is None


def test_a_rest_is_a_rest(window):
    window.run(3.0)
    window.drive(1.0)
    window.run(1.0)
    (motion,) = turtle_tape(window.frame).motions
    start = motion.rows[0][1]
    assert at(motion.rows, 2.9)[0] == start
    assert at(motion.rows, 3.9)[0] > start + 35


def test_a_teleport_is_a_jump_in_no_time(window):
    window.run(1.0)
    window.call("/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", x=1, y=2, theta=3)
    window.run(1.0)
    (motion,) = turtle_tape(window.frame).motions
    times = [row[0] for row in motion.rows]
    (jump,) = {time for time in times if times.count(time) == 2}
    assert metres(at(motion.rows, jump - 1e-6)) == pytest.approx((5.5444, 5.5444), abs=1e-3)
    assert metres(motion.rows[-1][1:3]) == pytest.approx((1, 2), abs=1e-3)


def test_a_turtle_that_is_killed_ends(window):
    window.call("/spawn", "turtlesim/Spawn", x=2, y=3, theta=0, name="ann")
    window.run(1.0)
    window.call("/kill", "turtlesim/Kill", name="ann")
    window.run(1.0)
    ann, turtle1 = turtle_tape(window.frame).motions
    assert (ann.name, turtle1.name) == ("ann", "turtle1")
    assert ann.until == pytest.approx(0.97, abs=0.02)
    assert (ann.number, turtle1.number) == (1, 0)


def test_trails_grow_with_the_turtle(window):
    window.drive(1.0, 0.5)
    window.run(6.0)
    tape = turtle_tape(window.frame)
    (motion,), (trail,) = tape.motions, tape.sheets[0].trails
    assert (trail.color, trail.width) == ("#b3b8ff", 3)
    for time in (1.0, 2.5, 5.9):
        assert at(trail.rows, time) == pytest.approx(at(motion.rows, time)[:2], abs=0.5)


def test_clearing_lays_a_new_sheet(window):
    window.drive(1.0)
    window.run(1.0)
    window.graph.params.set("/turtlesim/background_r", 200)
    window.call("/clear", "std_srvs/Empty")
    window.run(1.0)
    old, new = turtle_tape(window.frame).sheets
    assert (old.color, new.color) == ("#4556ff", "#c856ff")
    assert old.since == 0.0
    assert new.since == pytest.approx(0.97, abs=0.02)
    assert old.trails[0].rows[-1][0] <= new.since
    assert new.trails[0].rows[0][0] >= new.since - 0.001


def test_a_reset_begins_anew_and_keeps_the_past(window):
    window.drive(1.0)
    window.run(1.0)
    window.call("/reset", "std_srvs/Empty")
    window.run(1.0)
    tape = turtle_tape(window.frame)
    assert [motion.name for motion in tape.motions] == ["turtle1", "turtle1"]
    assert [motion.until is None for motion in tape.motions] == [False, True]
    assert len(tape.sheets) == 2


def test_before_the_first_update_nothing_is_on_the_tape(window):
    tape = turtle_tape(window.frame)
    assert tape.motions == ()
    assert tape.duration == 0.0


def test_a_turtle_that_is_nowhere_leaves_no_rows(window):
    window.run(0.1)
    nowhere = {"x": math.nan, "y": 1.0, "theta": 0.0}
    window.call("/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", **nowhere)
    window.run(0.1)
    (motion,) = turtle_tape(window.frame).motions
    assert all(math.isfinite(value) for row in motion.rows for value in row)
