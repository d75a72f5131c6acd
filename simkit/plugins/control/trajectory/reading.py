"""Trajectories of messages, as plain numbers; and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from simkit.plugins.control.trajectory.command import Point, TrajectoryCommand
from simkit.plugins.control.trajectory.spline import State
from simkit.plugins.control.trajectory.tolerances import JointTolerances, Tolerance


def read_command(message: Any) -> TrajectoryCommand:
    """What a trajectory_msgs/JointTrajectory asks for."""
    return TrajectoryCommand(
        joints=tuple(message.joint_names),
        points=tuple(
            Point(
                positions=tuple(point.positions),
                velocities=tuple(point.velocities),
                accelerations=tuple(point.accelerations),
                time_ns=point.time_from_start.to_nsec(),
            )
            for point in message.points
        ),
        stamp_ns=message.header.stamp.to_nsec(),
    )


def read_tolerances(
    goal: Any, names: Sequence[str], defaults: Sequence[JointTolerances]
) -> tuple[JointTolerances, ...]:
    """The tolerances of the joints for a control_msgs/FollowJointTrajectoryGoal."""
    found = []
    for name, tolerances in zip(names, defaults, strict=True):
        path, end = tolerances.path, tolerances.goal
        for one in goal.path_tolerance:
            if one.name == name:
                path = _changed(path, one)
        for one in goal.goal_tolerance:
            if one.name == name:
                end = _changed(end, one)
        changed = JointTolerances(path=path, goal=end, goal_time_s=tolerances.goal_time_s)
        found.append(changed.with_goal_time(goal.goal_time_tolerance.to_sec()))
    return tuple(found)


def _changed(tolerance: Tolerance, by: Any) -> Tolerance:
    """A tolerance with what a control_msgs/JointTolerance says."""
    return tolerance.changed(
        position=by.position, velocity=by.velocity, acceleration=by.acceleration
    )


def fill_states(
    message: Any, desired: Sequence[State], actual: Sequence[State], error: Sequence[State]
) -> None:
    """Write states into a message with the fields desired, actual and error."""
    message.desired.positions = [one.position for one in desired]
    message.desired.velocities = [one.velocity for one in desired]
    message.desired.accelerations = [one.acceleration for one in desired]
    for part, states in ((message.actual, actual), (message.error, error)):
        part.positions = [one.position for one in states]
        part.velocities = [one.velocity for one in states]
