"""Hardware interfaces, and the types of controllers that use them; the code of one is imported when it is loaded."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from simkit.plugins.control.controller import Controller

POSITION: Final = "PositionJointInterface"
VELOCITY: Final = "VelocityJointInterface"
EFFORT: Final = "EffortJointInterface"
STATE: Final = "JointStateInterface"
"""Every joint has it: to look, and not to command."""

INTERFACES: Final = (POSITION, VELOCITY, EFFORT)
"""Interfaces by which a joint is commanded; a joint in the simulation has one of them."""

PREFIX: Final = "hardware_interface/"
"""What stands before the name of an interface in a transmission."""

FAMILIES: Final = {
    POSITION: "position_controllers",
    VELOCITY: "velocity_controllers",
    EFFORT: "effort_controllers",
}
"""Package of the controllers that use an interface."""


def in_cpp(interface: str) -> str:
    """Its name in the messages of ros_control: `hardware_interface::PositionJointInterface`."""
    return f"hardware_interface::{interface}"


_INTERFACES = {
    **{family: interface for interface, family in FAMILIES.items()},
    "joint_state_controller": STATE,
    # Of these two there are the controllers, and in Gazebo no joint with such an interface.
    "pos_vel_controllers": "PosVelJointInterface",
    "pos_vel_acc_controllers": "PosVelAccJointInterface",
}

_TYPES = {
    ("joint_state", "JointStateController"): ("joint_state_controller/JointStateController",),
    ("joint_command", "JointCommandController"): (
        "position_controllers/JointPositionController",
        "velocity_controllers/JointVelocityController",
        "effort_controllers/JointEffortController",
        "position_controllers/JointGroupPositionController",
        "velocity_controllers/JointGroupVelocityController",
        "effort_controllers/JointGroupEffortController",
        "velocity_controllers/JointPositionController",
        "effort_controllers/JointPositionController",
        "effort_controllers/JointVelocityController",
        "effort_controllers/JointGroupPositionController",
    ),
    ("trajectory.controller", "JointTrajectoryController"): tuple(
        f"{family}/JointTrajectoryController"
        for family in (*FAMILIES.values(), "pos_vel_controllers", "pos_vel_acc_controllers")
    ),
}
"""Names of types by the module and the class that they share."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ControllerType:
    """One type of controller."""

    name: str
    """As a YAML file has it: `position_controllers/JointTrajectoryController`."""
    module: str
    """Python module of its class, in this package."""
    class_name: str
    """Its class."""

    @property
    def interface(self) -> str:
        """How it commands joints: `PositionJointInterface`."""
        return _INTERFACES[self.name.partition("/")[0]]

    @property
    def bare_name(self) -> str:
        """Its name without the package: `JointTrajectoryController`."""
        return self.name.partition("/")[2]

    def load(self) -> type[Controller]:
        """Its class."""
        module = importlib.import_module(f"{__package__}.{self.module}")
        found: type[Controller] = getattr(module, self.class_name)
        return found


CONTROLLER_TYPES: Final = {
    name: ControllerType(name=name, module=module, class_name=class_name)
    for (module, class_name), names in _TYPES.items()
    for name in names
}
"""All types of controllers, by name."""
