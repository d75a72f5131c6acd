"""Controllers that make a speed or an effort of an error, by the gains `pid`.

Source: effort_controllers and velocity_controllers of ros_controllers, texts and order.
"""

from __future__ import annotations

import math
from typing import Any

from simkit.msgs import message_class
from simkit.plugins.control.controller import Controller, stamp
from simkit.plugins.control.controllers.forward import (
    NO_GROUP_JOINT,
    NO_JOINT,
    group_names,
    group_targets,
    is_finite,
    joint_name,
)
from simkit.plugins.control.joint_drive import JointHandle, position_error
from simkit.plugins.control.limits import JointLimits
from simkit.plugins.control.pid import NO_GAIN, Pid, read_gains
from simkit.plugins.control.place import ControllerPlace, InitError
from simkit.urdf import Joint

EVERY = 10
"""One update of so many is published."""
_STATE = "control_msgs/JointControllerState"


class PidController(Controller):
    """One joint, told on the topic command (std_msgs/Float64); says on the topic state how it goes.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no joint or no gains.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        name = joint_name(place)
        self.pid = make_pid(place, "pid")
        self.joint = place.joint(name, NO_JOINT)
        self.claims = (name,)
        self.target = 0.0
        self._count = 0
        self._told: tuple[float, float, float, float] | None = None
        self._state = place.advertise("state", message_class(_STATE))
        place.subscribe("command", message_class("std_msgs/Float64"), self._hear)

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Forget old errors."""
        self.pid.reset()
        self._count, self._told = 0, None

    def tell(self, error: float, period_ns: int) -> None:
        """Keep what is published, of one update in ten."""
        if self._count % EVERY == 0:
            self._told = (self.target, error, period_ns * 1e-9, self.joint.command)
        self._count += 1

    def value(self) -> tuple[float, float]:
        """What is controlled, and how fast it changes."""
        raise NotImplementedError

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - the form of Controller
        """One update in ten."""
        return self._told is not None

    def publish(self, time_ns: int) -> None:
        """Say what was wanted, and what is."""
        assert self._told is not None
        message: Any = message_class(_STATE)()
        gains = self.pid.gains
        message.header.stamp = stamp(time_ns)
        message.set_point, message.error, message.time_step, message.command = self._told
        message.process_value, message.process_value_dot = self.value()
        message.p, message.i, message.d = gains.p, gains.i, gains.d
        message.i_clamp, message.antiwindup = gains.i_max, gains.antiwindup
        self._told = None
        self._state.publish(message)

    def _hear(self, message: Any) -> None:
        if is_finite(self.place, message.data):
            self.target = message.data


class PositionPid(PidController):
    """Drives a joint to a position.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no joint or no gains, or the URDF does not have the joint.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        self._urdf = urdf_joint(place, self.joint.name)

    def starting(self, time_ns: int) -> None:
        """Hold the joint where it is."""
        super().starting(time_ns)
        self.target = self.joint.position

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Push the joint towards its position."""
        self.target = within(self._urdf, self.target)
        error = position_way(self._urdf, self.joint, self.target)
        self.joint.command = self.pid.command(
            error, period_ns * 1e-9, rate=0.0 - self.joint.velocity
        )
        self.tell(error, period_ns)

    def value(self) -> tuple[float, float]:
        """Position and velocity of the joint."""
        return self.joint.position, self.joint.velocity


class VelocityPid(PidController):
    """Drives a joint at a velocity."""

    def starting(self, time_ns: int) -> None:
        """Bring the joint to rest."""
        super().starting(time_ns)
        self.target = 0.0

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Push the joint towards its velocity."""
        error = self.target - self.joint.velocity
        self.joint.command = self.pid.command(error, period_ns * 1e-9)
        self.tell(error, period_ns)

    def value(self) -> tuple[float, float]:
        """Velocity of the joint, and its effort."""
        return self.joint.velocity, self.joint.effort


class PositionPidGroup(Controller):
    """Drives several joints to positions, told on the topic command (std_msgs/Float64MultiArray).

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no joints, or one has no gains.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        self.claims = group_names(place)
        self._joints = [place.joint(name, NO_GROUP_JOINT) for name in self.claims]
        self._urdf = [urdf_joint(place, name) for name in self.claims]
        self._pids = [make_pid(place, f"{name}/pid") for name in self.claims]
        self._targets = [0.0] * len(self._joints)
        place.subscribe("command", message_class("std_msgs/Float64MultiArray"), self._hear)

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hold the joints where they are."""
        for pid in self._pids:
            pid.reset()
        self._targets = [one.position for one in self._joints]

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Push the joints towards their positions."""
        for number, joint in enumerate(self._joints):
            target = within(self._urdf[number], self._targets[number])
            error = position_way(self._urdf[number], joint, target)
            joint.command = self._pids[number].command(error, period_ns * 1e-9)

    def _hear(self, message: Any) -> None:
        targets = group_targets(self.place, self.claims, message.data)
        if targets is not None:
            self._targets = targets


def make_pid(place: ControllerPlace, key: str) -> Pid:
    """The PID of the gains below a parameter.

    Raises:
        InitError: There are none.
    """
    namespace = f"{place.namespace}/{key}"
    gains = read_gains(place.node.graph.params, namespace)
    if gains is None:
        raise InitError(
            NO_GAIN.format(namespace=namespace),
            hint=f"{place.type_name} makes commands by gains: add {key.replace('/', ': {')}: "
            f"{{p: 100.0, i: 0.01, d: 10.0}}{'}' * key.count('/')} in the YAML file, and try out the "
            "numbers",
        )
    return Pid(gains)


def urdf_joint(place: ControllerPlace, name: str) -> Joint:
    """A joint as the URDF has it.

    Raises:
        InitError: It does not have it.
    """
    found = place.robot().joints.get(name)
    if found is None:
        raise InitError(f"Could not find joint '{name}' in urdf")
    return found


def within(joint: Joint, position: float) -> float:
    """A position within the limits of a joint that has limits [rad or m]."""
    limits = _limits(joint)
    return min(max(position, limits.lower), limits.upper)


def position_way(joint: Joint, handle: JointHandle, target: float) -> float:
    """How far a joint has to go [rad or m]."""
    return position_error(joint.type, handle.position, target, _limits(joint))


def _limits(joint: Joint) -> JointLimits:
    limit = joint.limit
    has_ends = limit is not None and joint.type.value in ("revolute", "prismatic")
    if limit is None or not has_ends:
        return JointLimits(lower=-math.inf, upper=math.inf)
    return JointLimits(lower=limit.lower, upper=limit.upper)
