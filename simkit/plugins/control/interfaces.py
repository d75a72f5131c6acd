"""Hardware interfaces: what can be said to a joint, and by which family of controllers."""

from __future__ import annotations

from typing import Final

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
