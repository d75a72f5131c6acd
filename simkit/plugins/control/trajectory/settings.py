"""What the parameters of a JointTrajectoryController say, and what a goal changes of it.

Source: `JointTrajectoryController::init`, `getSegmentTolerances`, `tolerances.h`: texts and defaults.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from simkit.errors import near_names
from simkit.plugins.control.controller import Controller, InitError
from simkit.urdf import JointType

if TYPE_CHECKING:
    from simkit.plugins.control.trajectory.segment import State


@dataclass(frozen=True, slots=True, kw_only=True)
class Tolerance:
    """Largest errors of a state; 0 for what is not looked at."""

    position: float = 0.0
    """[rad or m]."""
    velocity: float = 0.0
    """[rad/s or m/s]."""
    acceleration: float = 0.0
    """[rad/s^2 or m/s^2]."""

    def allows(self, error: State) -> bool:
        """Whether an error is within it."""
        return not (
            0.0 < self.position < abs(error.position)
            or 0.0 < self.velocity < abs(error.velocity)
            or 0.0 < self.acceleration < abs(error.acceleration)
        )

    def changed(self, by: Any) -> Tolerance:
        """This, changed by a control_msgs/JointTolerance."""
        return Tolerance(
            position=_changed(self.position, by.position),
            velocity=_changed(self.velocity, by.velocity),
            acceleration=_changed(self.acceleration, by.acceleration),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class JointTolerances:
    """The tolerances of one joint."""

    path: Tolerance = Tolerance()
    """On the way."""
    goal: Tolerance = Tolerance()
    """At the end."""
    goal_time_s: float = 0.0
    """How long it may take, after the end, to come within the tolerance there [s]."""


NO_TOLERANCES = JointTolerances()
"""Nothing is looked at."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlledJoints:
    """What the controller knows of its joints."""

    names: tuple[str, ...]
    """Their names."""
    turns: tuple[bool, ...]
    """Whether each turns without end: then it takes the short way."""
    tolerances: tuple[JointTolerances, ...]
    """What is looked at while a goal is followed."""
    allow_partial: bool = False
    """Whether a command may leave out some of them."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TrajectorySettings:
    """What the parameters say."""

    joints: ControlledJoints
    """The joints that it moves."""
    state_publish_rate: float
    """Messages a second on the topic `state` [Hz]."""
    action_monitor_rate: float
    """How often a second a goal is looked at [Hz]."""
    stop_ns: int
    """How long it takes to come to rest [ns]; 0: it holds where it is."""


def settings_of(controller: Controller) -> TrajectorySettings:
    """The settings of a controller.

    Raises:
        InitError: They do not fit together or the robot.
    """
    state_rate = controller.number("state_publish_rate", 50.0, is_positive=True)
    monitor_rate = controller.number("action_monitor_rate", 20.0, is_positive=True)
    stop_s = controller.number("stop_trajectory_duration", 0.0)
    names = controller.joint_names()
    turns = _turns(controller, names)
    return TrajectorySettings(
        joints=ControlledJoints(
            names=names,
            turns=turns,
            tolerances=_tolerances(controller, names),
            allow_partial=bool(controller.parameter("allow_partial_joints_goal", False)),
        ),
        state_publish_rate=state_rate,
        action_monitor_rate=monitor_rate,
        stop_ns=max(0, round(stop_s * 1e9)),
    )


def _turns(controller: Controller, names: tuple[str, ...]) -> tuple[bool, ...]:
    """Which joints turn without end."""
    known = controller.robot().joints
    for name in names:
        if name not in known:
            near = near_names(name, known)
            moving = ", ".join(one.name for one in known.values() if one.moves)
            raise InitError(
                f"Could not find joint '{name}' in URDF model.",
                hint=f"did you mean {near[0]}?" if near else f"the joints that move are: {moving}",
            )
    return tuple(known[name].type is JointType.CONTINUOUS for name in names)


def _tolerances(controller: Controller, names: tuple[str, ...]) -> tuple[JointTolerances, ...]:
    at_rest = controller.number("constraints/stopped_velocity_tolerance", 0.01)
    goal_time_s = controller.number("constraints/goal_time", 0.0)
    return tuple(
        JointTolerances(
            path=Tolerance(position=controller.number(f"constraints/{name}/trajectory", 0.0)),
            goal=Tolerance(
                position=controller.number(f"constraints/{name}/goal", 0.0), velocity=at_rest
            ),
            goal_time_s=goal_time_s,
        )
        for name in names
    )


def goal_tolerances(
    goal: Any, names: Sequence[str], defaults: Sequence[JointTolerances]
) -> tuple[JointTolerances, ...]:
    """The tolerances of the joints for a control_msgs/FollowJointTrajectoryGoal."""
    found = []
    for name, tolerances in zip(names, defaults, strict=True):
        path, end = tolerances.path, tolerances.goal
        for one in goal.path_tolerance:
            if one.name == name:
                path = path.changed(one)
        for one in goal.goal_tolerance:
            if one.name == name:
                end = end.changed(one)
        goal_time_s = _changed(tolerances.goal_time_s, goal.goal_time_tolerance.to_sec())
        found.append(JointTolerances(path=path, goal=end, goal_time_s=goal_time_s))
    return tuple(found)


def _changed(value: float, by: float) -> float:
    """A tolerance changed by a goal: above 0 it replaces, below 0 it removes, 0 changes nothing."""
    if by > 0.0:
        return by
    return 0.0 if by < 0.0 else value
