"""Tolerances: what is allowed, and what a goal says of them."""

from __future__ import annotations

import pytest

from simkit.msgs import Duration, message_class
from simkit.plugins.control.trajectory.segment import State
from simkit.plugins.control.trajectory.settings import (
    JointTolerances,
    Tolerance,
    goal_tolerances,
)


@pytest.mark.parametrize(
    ("error", "is_allowed"),
    [
        (State(0.1), True),
        (State(-0.1), True),
        (State(0.11), False),
        (State(-0.11), False),
        (State(0.0, 0.21), False),
        (State(0.0, 0.2, 1e9), True),
    ],
)
def test_an_error_is_within_a_tolerance_or_not(error, is_allowed):
    assert Tolerance(position=0.1, velocity=0.2).allows(error) is is_allowed


def test_no_tolerance_allows_everything():
    assert Tolerance().allows(State(1e9, 1e9, 1e9))


def test_a_goal_changes_keeps_and_takes_away():
    tolerance = Tolerance(position=0.1, velocity=0.2, acceleration=0.3)
    kind = message_class("control_msgs/JointTolerance")
    said = kind(position=0.5, velocity=-1.0, acceleration=0.0)
    assert tolerance.changed(said) == Tolerance(position=0.5, velocity=0.0, acceleration=0.3)


@pytest.mark.parametrize(("said", "goal_time"), [(2.0, 2.0), (0.0, 0.7), (-1.0, 0.0)])
def test_a_goal_says_how_long_its_end_may_take(said, goal_time):
    goal = message_class("control_msgs/FollowJointTrajectoryGoal")()
    goal.goal_time_tolerance = Duration.from_nsec(round(said * 1e9))
    (found,) = goal_tolerances(goal, ["hip"], [JointTolerances(goal_time_s=0.7)])
    assert found.goal_time_s == goal_time
