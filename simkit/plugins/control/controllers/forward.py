"""Controllers that hand on what they are told: a position, a velocity or an effort, as it is.

Source: forward_command_controller of ros_controllers, texts.
"""

from __future__ import annotations

import math
from typing import Any

from simkit.msgs import message_class
from simkit.plugins.control.controller import Controller
from simkit.plugins.control.place import ControllerPlace, InitError

NO_GROUP_JOINT = "Exception thrown: Could not find resource '{joint}' in '{interface}'."
NO_JOINT = (
    "Exception thrown while initializing controller '{controller}'.\n"
    "Could not find resource '{joint}' in '{interface}'."
)
"""What is said of a joint that is not there, or has another interface."""


class ForwardController(Controller):
    """One joint, told on the topic command (std_msgs/Float64).

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no joint.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        self.joint = place.joint(joint_name(place), NO_JOINT)
        self.claims = (self.joint.name,)
        self.target = 0.0
        place.subscribe("command", message_class("std_msgs/Float64"), self._hear)

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hand the command on."""
        self.joint.command = self.target

    def _hear(self, message: Any) -> None:
        if is_finite(self.place, message.data):
            self.target = message.data


class RestingController(ForwardController):
    """Begins with a velocity or effort of 0."""

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Do nothing until it is told."""
        self.target = 0.0


class HoldingController(ForwardController):
    """Begins with the position that the joint has."""

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hold the joint where it is."""
        self.target = self.joint.position


class ForwardGroup(Controller):
    """Several joints, told on the topic command (std_msgs/Float64MultiArray), in the order of its joints.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no joints.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        self.claims = group_names(place)
        self.joints = [place.joint(name, NO_GROUP_JOINT) for name in self.claims]
        self.targets = [0.0] * len(self.joints)
        kind = message_class("std_msgs/Float64MultiArray")
        place.subscribe("command", kind, self._hear)

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hand the commands on."""
        for joint, target in zip(self.joints, self.targets, strict=True):
            joint.command = target

    def _hear(self, message: Any) -> None:
        targets = group_targets(self.place, self.claims, message.data)
        if targets is not None:
            self.targets = targets


class RestingGroup(ForwardGroup):
    """Begins with velocities or efforts of 0."""

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Do nothing until it is told."""
        self.targets = [0.0] * len(self.joints)


class HoldingGroup(ForwardGroup):
    """Begins with the positions that the joints have."""

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hold the joints where they are."""
        self.targets = [one.position for one in self.joints]


def joint_name(place: ControllerPlace) -> str:
    """The parameter `joint` of a controller.

    Raises:
        InitError: There is none.
    """
    name = place.parameter("joint")
    if not isinstance(name, str) or not name:
        joints = ", ".join(place.hardware.joints_of(place.interface)) or "none"
        raise InitError(
            f"No joint given (namespace: {place.namespace})",
            hint=f"write joint: ... in the YAML file; joints with a {place.interface}: {joints}",
        )
    return name


def group_names(place: ControllerPlace) -> tuple[str, ...]:
    """The parameter `joints` of a group.

    Raises:
        InitError: There is none.
    """
    if place.parameter("joints") is None:
        raise InitError(
            f"Failed to getParam 'joints' (namespace: {place.namespace}).",
            hint="write joints: [hip, shoulder] in the YAML file",
        )
    return place.names("joints")


def group_targets(place: ControllerPlace, names: tuple[str, ...], data: Any) -> list[float] | None:
    """The numbers of a command for a group; None if they are refused."""
    if len(data) != len(names):
        place.node.error(
            f"Dimension of command ({len(data)}) does not match number of joints ({len(names)})! Not "
            "executing!"
        )
        place.node.warn(f"hint: data must have one number for each of {', '.join(names)}")
        return None
    return list(data) if all(is_finite(place, one) for one in data) else None


def is_finite(place: ControllerPlace, value: float) -> bool:
    """Whether a command is a number; says so if not."""
    if not math.isfinite(value):
        place.node.error(
            f"{place.namespace}/command says {value}, which is no number: not executing"
        )
        return False
    return True
