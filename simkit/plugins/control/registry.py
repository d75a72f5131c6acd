"""Which types of controllers there are; the code of one is imported when it is loaded."""

from __future__ import annotations

import importlib
from dataclasses import dataclass

from simkit.plugins.control.controller import Controller
from simkit.plugins.control.interfaces import EFFORT, POSITION, STATE, VELOCITY

_HERE = "simkit.plugins.control"


@dataclass(frozen=True, slots=True, kw_only=True)
class ControllerEntry:
    """One type of controller."""

    type_name: str
    """As a YAML file has it: `position_controllers/JointTrajectoryController`."""
    interface: str
    """What it tells joints: `PositionJointInterface`."""
    module: str
    """Python module of its class."""
    class_name: str
    """Its class."""

    def load(self) -> type[Controller]:
        """Its class."""
        found: type[Controller] = getattr(importlib.import_module(self.module), self.class_name)
        return found


def _entry(type_name: str, interface: str, place: str, class_name: str) -> ControllerEntry:
    return ControllerEntry(
        type_name=type_name, interface=interface, module=f"{_HERE}.{place}", class_name=class_name
    )


_FORWARD, _PID = "controllers.forward", "controllers.pid_controllers"


def _trajectory_entry(family: str, interface: str) -> ControllerEntry:
    name = "JointTrajectoryController"
    return _entry(f"{family}/{name}", interface, "trajectory.controller", name)


_ENTRIES = (
    _entry(
        "joint_state_controller/JointStateController",
        STATE,
        "controllers.joint_state",
        "JointStateController",
    ),
    _entry("position_controllers/JointPositionController", POSITION, _FORWARD, "HoldingController"),
    _entry("velocity_controllers/JointVelocityController", VELOCITY, _FORWARD, "RestingController"),
    _entry("effort_controllers/JointEffortController", EFFORT, _FORWARD, "RestingController"),
    _entry("position_controllers/JointGroupPositionController", POSITION, _FORWARD, "HoldingGroup"),
    _entry("velocity_controllers/JointGroupVelocityController", VELOCITY, _FORWARD, "RestingGroup"),
    _entry("effort_controllers/JointGroupEffortController", EFFORT, _FORWARD, "RestingGroup"),
    _entry("velocity_controllers/JointPositionController", VELOCITY, _PID, "PositionPid"),
    _entry("effort_controllers/JointPositionController", EFFORT, _PID, "PositionPid"),
    _entry("effort_controllers/JointVelocityController", EFFORT, _PID, "VelocityPid"),
    _entry("effort_controllers/JointGroupPositionController", EFFORT, _PID, "PositionPidGroup"),
    _trajectory_entry("position_controllers", POSITION),
    _trajectory_entry("velocity_controllers", VELOCITY),
    _trajectory_entry("effort_controllers", EFFORT),
    # Of these two there are the controllers, and in Gazebo no joint with such an interface.
    _trajectory_entry("pos_vel_controllers", "PosVelJointInterface"),
    _trajectory_entry("pos_vel_acc_controllers", "PosVelAccJointInterface"),
)


def controllers() -> dict[str, ControllerEntry]:
    """All types of controllers, by name."""
    return {entry.type_name: entry for entry in _ENTRIES}
