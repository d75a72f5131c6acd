"""Commands that are refused: the words of the original, and which point and joint it is."""

from __future__ import annotations

import math

import pytest

from simkit.plugins.control.trajectory.command import (
    Point,
    TrajectoryCommand,
    TrajectoryRefused,
    check_point,
    check_times,
    map_joints,
)

JOINTS = ("hip", "shoulder")
EXPECTED = "Cannot create trajectory from message. It does not contain the expected joints."
SIZES = "Size mismatch in trajectory point position, velocity or acceleration data."


def command(*points, names=JOINTS):
    return TrajectoryCommand(joints=names, points=points)


def refusal(call, *arguments, **options):
    with pytest.raises(TrajectoryRefused) as found:
        call(*arguments, **options)
    return str(found.value), found.value.hint


@pytest.mark.parametrize("second_ns", [10**9, 5 * 10**8])
def test_points_must_come_one_after_the_other(second_ns):
    points = [Point(positions=(0.0, 0.0), time_ns=time) for time in (10**9, second_ns)]
    text, hint = refusal(check_times, command(*points))
    assert text == "Trajectory message contains waypoints that are not strictly increasing in time."
    assert "points[1]" in hint
    assert "points[0] at 1 s" in hint


@pytest.mark.parametrize(
    ("names", "hint"),
    [
        (("hip", "sholder"), "did you mean 'shoulder'?"),
        (("hip",), "lacks shoulder"),
        (("hip", "hip"), "'hip' twice"),
        (("hip", "shoulder", "elbow"), "has 'elbow'"),
        ((), "lacks hip, shoulder"),
    ],
)
def test_the_joints_must_be_those_of_the_controller(names, hint):
    text, found = refusal(map_joints, command(names=names), JOINTS, allow_partial=False)
    assert text == EXPECTED
    assert hint in found


def test_a_partial_command_may_leave_out_some_joints_but_not_all():
    one = command(names=("shoulder",))
    assert map_joints(one, JOINTS, allow_partial=True) == (1,)
    text, _ = refusal(map_joints, command(names=()), JOINTS, allow_partial=True)
    assert text == EXPECTED


@pytest.mark.parametrize(
    ("point", "hint"),
    [
        ({"positions": (1.0,)}, "points[0].positions has 1 number, and joint_names has 2 joints"),
        ({"positions": (1.0, 2.0, 3.0)}, "points[0].positions has 3 numbers"),
        ({"positions": (1.0, 2.0), "velocities": (1.0,)}, "points[0].velocities has 1 number"),
        (
            {"positions": (1.0, 2.0), "accelerations": (1.0,)},
            "points[0].accelerations has 1 number",
        ),
        ({"positions": (), "velocities": (1.0, 2.0)}, "points[0].positions has 0 numbers"),
    ],
)
def test_a_point_must_have_a_number_for_each_joint(point, hint):
    text, found = refusal(check_point, command(Point(**point, time_ns=1)), 0)
    assert text == SIZES
    assert hint in found


def test_a_point_without_positions_has_words_of_its_own():
    text, hint = refusal(check_point, command(Point(positions=(), time_ns=1)), 0)
    assert text == "Quintic spline segment can't be constructed: Endpoint positions can't be empty."
    assert "hip, shoulder" in hint


@pytest.mark.parametrize("value", [math.nan, -math.inf, 1e10])
def test_what_is_no_number_is_refused(value):
    text, _ = refusal(check_point, command(Point(positions=(0.0, value), time_ns=1)), 0)
    assert "points[0].positions, for shoulder" in text
