"""The parameters of a JointTrajectoryController.

Source: `JointTrajectoryController::init`, `getSegmentTolerances`, texts and defaults.
"""

from __future__ import annotations

from dataclasses import dataclass

from simkit.errors import near_names
from simkit.plugins.control.place import ControllerPlace, InitError
from simkit.plugins.control.trajectory.replacement import ControlledJoints
from simkit.plugins.control.trajectory.tolerances import JointTolerances, Tolerance
from simkit.urdf import JointType


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


def read_settings(place: ControllerPlace) -> TrajectorySettings:
    """The settings of a controller.

    Raises:
        InitError: They are of no use.
    """
    state_rate = place.number("state_publish_rate", 50.0, is_positive=True)
    monitor_rate = place.number("action_monitor_rate", 20.0, is_positive=True)
    stop_s = place.number("stop_trajectory_duration", 0.0)
    names = place.names("joints")
    turns = _turns(place, names)
    return TrajectorySettings(
        joints=ControlledJoints(
            names=names,
            turns=turns,
            tolerances=_tolerances(place, names),
            allow_partial=bool(place.parameter("allow_partial_joints_goal", False)),
        ),
        state_publish_rate=state_rate,
        action_monitor_rate=monitor_rate,
        stop_ns=max(0, round(stop_s * 1e9)),
    )


def _turns(place: ControllerPlace, names: tuple[str, ...]) -> tuple[bool, ...]:
    """Which joints turn without end."""
    known = place.robot().joints
    for name in names:
        if name not in known:
            near = near_names(name, known)
            moving = ", ".join(one.name for one in known.values() if one.moves)
            raise InitError(
                f"Could not find joint '{name}' in URDF model.",
                hint=f"did you mean {near[0]}?" if near else f"the joints that move are: {moving}",
            )
    return tuple(known[name].type is JointType.CONTINUOUS for name in names)


def _tolerances(place: ControllerPlace, names: tuple[str, ...]) -> tuple[JointTolerances, ...]:
    at_rest = place.number("constraints/stopped_velocity_tolerance", 0.01)
    goal_time_s = place.number("constraints/goal_time", 0.0)
    return tuple(
        JointTolerances(
            path=Tolerance(position=place.number(f"constraints/{name}/trajectory", 0.0)),
            goal=Tolerance(
                position=place.number(f"constraints/{name}/goal", 0.0), velocity=at_rest
            ),
            goal_time_s=goal_time_s,
        )
        for name in names
    )
