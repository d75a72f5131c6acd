"""A command in the middle of a trajectory: bridges, counts of segments, short ways, partial commands.

The numbers are those of the tests of joint_trajectory_controller.
"""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from simkit.plugins.control.trajectory.command import Point, TrajectoryCommand, TrajectoryRefused
from simkit.plugins.control.trajectory.replacement import Instant, replace_trajectories
from simkit.plugins.control.trajectory.segment import (
    Knot,
    State,
    find_segment,
    hold,
    sample,
    segment_between,
    stop,
)
from simkit.plugins.control.trajectory.settings import (
    NO_TOLERANCES,
    ControlledJoints,
    JointTolerances,
    Tolerance,
)

S = 1_000_000_000


def joints(*names, turns=False, allow_partial=False, tolerances=NO_TOLERANCES):
    return ControlledJoints(
        names=names or ("a",),
        turns=(turns,) * (len(names) or 1),
        tolerances=(tolerances,) * (len(names) or 1),
        allow_partial=allow_partial,
    )


def point(time_s, *positions, velocities=(), accelerations=()):
    return Point(
        positions=positions,
        velocities=velocities,
        accelerations=accelerations,
        time_ns=round(time_s * S),
    )


def command(*points, names=("a",), stamp_s=0.0):
    return TrajectoryCommand(joints=names, points=points, stamp_ns=round(stamp_s * S))


def at(time_s, uptime_s=None):
    uptime_s = time_s if uptime_s is None else uptime_s
    return Instant(time_ns=round(time_s * S), uptime_ns=round(uptime_s * S))


THREE = (point(1, 2.0), point(2, 4.0), point(3, 3.0))


def test_from_rest_positions_are_reached_in_straight_lines():
    found = replace_trajectories([hold(0.0, 0)], command(*THREE), joints(), at(0.001))
    (trajectory,) = found.trajectories
    positions = [
        sample(trajectory, round(t * S)).position for t in (0.001, 0.501, 1.001, 1.501, 3.001)
    ]
    assert positions == pytest.approx([0.0, 1.0, 2.0, 3.0, 3.0], abs=1e-12)
    assert sample(trajectory, 10 * S) == State(3.0)


@pytest.mark.parametrize(
    ("now_s", "segments"), [(1.0, 4), (1.5, 4), (2.0, 3), (2.5, 3), (3.0, 2), (3.5, 2)]
)
def test_what_is_left_of_the_old_one_a_bridge_and_what_is_left_of_the_new_one(now_s, segments):
    old = (segment_between(0, Knot(position=0.0), 9 * S, Knot(position=9.0)),)
    found = replace_trajectories([old], command(*THREE, stamp_s=1.0), joints(), at(now_s))
    assert len(found.trajectories[0]) == segments


def test_all_points_past_is_refused():
    old = [hold(0.0, 0)]
    with pytest.raises(TrajectoryRefused) as refusal:
        replace_trajectories(old, command(*THREE, stamp_s=1.0), joints(), at(4.0))
    assert str(refusal.value) == (
        "Dropping all 3 trajectory point(s), as they occur before the current time.\n"
        "Last point is 0.000000s in the past."
    )
    assert refusal.value.is_late
    assert "stamp" in refusal.value.hint


def test_a_time_of_zero_is_explained():
    with pytest.raises(TrajectoryRefused) as refusal:
        replace_trajectories([hold(0.0, 0)], command(point(0, 1.0)), joints(), at(5.0))
    assert "time_from_start is 0 s" in refusal.value.hint


def test_points_that_are_past_are_dropped_and_counted():
    found = replace_trajectories(
        [hold(0.0, 0)], command(*THREE, stamp_s=1.0), joints(), at(2.25, uptime_s=0.25)
    )
    assert (found.dropped, found.first_in_s) == (1, pytest.approx(0.75))
    assert sample(found.trajectories[0], S).position == 4.0


def test_a_first_point_at_time_zero_is_dropped_in_silence():
    points = (point(0, 5.0), point(1, 1.0))
    found = replace_trajectories([hold(0.0, 0)], command(*points), joints(), at(2.0))
    assert found.dropped == 0
    assert sample(found.trajectories[0], round(2.5 * S)).position == pytest.approx(0.5)


def test_the_old_one_goes_on_until_the_new_one_starts():
    old = (segment_between(0, Knot(position=0.0), 10 * S, Knot(position=10.0)),)
    asked = command(point(1, 0.0), stamp_s=4.0)
    (trajectory,) = replace_trajectories([old], asked, joints(), at(2.0)).trajectories
    positions = [sample(trajectory, round(t * S)).position for t in (2.0, 3.0, 4.0, 4.5, 5.0)]
    assert positions == pytest.approx([2.0, 3.0, 4.0, 2.0, 0.0], abs=1e-12)


def test_a_bridge_begins_with_position_velocity_and_acceleration_that_are_desired():
    start = Knot(position=0.0, velocity=0.5, acceleration=-1.0)
    old = (segment_between(0, start, 4 * S, Knot(position=2.0, velocity=1.0, acceleration=0.0)),)
    asked = command(point(2, -1.0, velocities=(0.3,), accelerations=(0.1,)), stamp_s=1.0)
    (trajectory,) = replace_trajectories([old], asked, joints(), at(0.5)).trajectories
    before, after = old[0].sample(S), sample(trajectory, S)
    for name in ("position", "velocity", "acceleration"):
        assert getattr(after, name) == pytest.approx(getattr(before, name), abs=1e-12)
    end = sample(trajectory, 3 * S)
    assert (end.position, end.velocity, end.acceleration) == pytest.approx(
        (-1.0, 0.3, 0.1), abs=1e-12
    )


def test_stamps_are_on_the_clock_of_the_world_and_trajectories_on_that_of_the_controller():
    asked = command(point(1, 1.0), stamp_s=101.0)
    (trajectory,) = replace_trajectories(
        [hold(0.0, 0)], asked, joints(), at(100.0, uptime_s=3.0)
    ).trajectories
    assert [sample(trajectory, round(t * S)).position for t in (4.0, 4.5, 5.0)] == [0.0, 0.5, 1.0]


def test_joints_that_turn_take_the_short_way():
    names, two = ("a", "b"), joints("a", "b", turns=True)
    here = [hold(0.25 * math.pi, 0), hold(0.5 * math.pi, 0)]
    asked = command(point(1, 4.5 * math.pi, -1.75 * math.pi), names=names)
    found = replace_trajectories(here, asked, two, at(0.0)).trajectories
    ends = [sample(one, 9 * S).position for one in found]
    assert ends == pytest.approx([0.5 * math.pi, 0.25 * math.pi], abs=1e-12)


def test_half_a_turn_is_not_wrapped():
    asked = command(point(1, 0.5 * math.pi))
    found = replace_trajectories([hold(-0.5 * math.pi, 0)], asked, joints(turns=True), at(0.0))
    assert sample(found.trajectories[0], S).position == 0.5 * math.pi


def test_the_offset_of_the_first_point_holds_for_all():
    turn = 2.0 * math.pi
    asked = command(point(1, turn + 0.1), point(2, 2.0 * turn))
    found = replace_trajectories([hold(0.0, 0)], asked, joints(turns=True), at(0.0))
    ends = [sample(found.trajectories[0], t * S).position for t in (1, 2)]
    assert ends == pytest.approx([0.1, turn], abs=1e-12)


def test_a_joint_with_ends_does_not_turn_round():
    asked = command(point(1, 4.5 * math.pi))
    found = replace_trajectories([hold(0.0, 0)], asked, joints(turns=False), at(0.0))
    assert sample(found.trajectories[0], S).position == 4.5 * math.pi


def test_the_order_of_the_names_is_that_of_the_command():
    asked = command(point(1, 1.0, 2.0, 3.0), names=("c", "a", "b"))
    found = replace_trajectories([hold(0.0, 0)] * 3, asked, joints("a", "b", "c"), at(0.0))
    assert [sample(one, S).position for one in found.trajectories] == [2.0, 3.0, 1.0]


def test_a_partial_command_leaves_the_other_joints_to_what_they_do():
    old = (segment_between(0, Knot(position=0.0), 4 * S, Knot(position=4.0)),)
    asked = command(point(1, -1.0), names=("b",))
    goal = object()
    found = replace_trajectories(
        [old, hold(0.0, 0)], asked, joints("a", "b", allow_partial=True), at(1.0), goal=goal
    ).trajectories
    assert [sample(one, 2 * S).position for one in found] == [2.0, -1.0]
    assert {segment.goal for segment in found[0]} == {goal}


def test_new_segments_belong_to_the_goal_and_have_its_tolerances():
    tolerances = JointTolerances(path=Tolerance(position=0.1))
    goal = object()
    old = hold(0.0, 0)
    (trajectory,) = replace_trajectories(
        [old], command(*THREE), joints(tolerances=tolerances), at(0.0), goal=goal
    ).trajectories
    assert [one.goal for one in trajectory] == [None, goal, goal, goal]
    assert [one.tolerances for one in trajectory[1:]] == [tolerances] * 3


def test_no_command_makes_a_joint_jump():
    rng = np.random.default_rng(3)
    trajectory, uptime_s = hold(0.0, 0), 0.0
    for _ in range(300):
        uptime_s += float(rng.uniform(0.001, 1.5))
        times = np.cumsum(rng.uniform(0.01, 1.0, 3)).tolist()
        kinds = rng.integers(0, 3)
        points = [
            point(
                time,
                float(rng.uniform(-9.0, 9.0)),
                velocities=tuple(rng.uniform(-2.0, 2.0, 1).tolist()) if kinds > 0 else (),
                accelerations=tuple(rng.uniform(-2.0, 2.0, 1).tolist()) if kinds > 1 else (),
            )
            for time in times
        ]
        stamp_s = uptime_s + float(rng.uniform(0.0, 1.0)) if rng.integers(2) else 0.0
        asked = command(*points, stamp_s=stamp_s)
        now = at(uptime_s)
        (new,) = replace_trajectories([trajectory], asked, joints(turns=True), now).trajectories
        start_ns = max(asked.stamp_ns, now.uptime_ns)
        for time_ns in (now.uptime_ns, (now.uptime_ns + start_ns) // 2, start_ns):
            here, before = sample(new, time_ns), sample(trajectory, time_ns)
            assert here.position == pytest.approx(before.position, abs=1e-12)
        for before, after in itertools.pairwise(new):
            state = after.sample(after.start_ns)
            assert state.position == pytest.approx(before.sample(after.start_ns).position, abs=1e-9)
        bridge = new[find_segment(new, start_ns)]
        assert abs(bridge.end_position - sample(new, start_ns).position) <= math.pi + 1e-9
        trajectory = new


def test_a_refusal_leaves_everything_as_it_is():
    old = [hold(0.0, 0)]
    with pytest.raises(TrajectoryRefused):
        replace_trajectories(old, command(point(1, 1.0), point(1, 2.0)), joints(), at(0.0))
    assert old == [hold(0.0, 0)]


# -- coming to rest: holding, and the ramp


SECOND = 1_000_000_000


def test_to_hold_is_to_stay_for_ever():
    trajectory = hold(0.3, SECOND)
    assert {sample(trajectory, t * SECOND) for t in range(4)} == {State(0.3)}


@pytest.mark.parametrize(("position", "velocity", "duration_s"), [(0.2, 1.0, 1), (-1.0, -0.5, 2)])
def test_a_ramp_begins_as_the_joint_moves_and_ends_at_rest(position, velocity, duration_s):
    trajectory = stop(State(position, velocity), SECOND, duration_s * SECOND)
    begin = sample(trajectory, SECOND)
    assert (begin.position, begin.velocity) == (position, velocity)
    end = sample(trajectory, (1 + duration_s) * SECOND)
    assert end.velocity == pytest.approx(0.0, abs=1e-12)
    # The middle of the quintic from (p, v, 0) to (p, -v, 0) in a time 2 d is 5/8 of v d away.
    assert end.position == pytest.approx(position + 0.625 * velocity * duration_s, abs=1e-12)
    assert sample(trajectory, 9 * SECOND) == State(end.position)


def test_a_joint_at_rest_stays():
    trajectory = stop(State(0.4), 0, SECOND)
    assert {sample(trajectory, t * SECOND // 4).position for t in range(8)} == {0.4}
