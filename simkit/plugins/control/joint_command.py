"""Controllers that follow the newest command: for one joint, or for a group of joints.

A controller is defined by the name of its type: the package names the interface of its joints, `Group` makes
it one for several joints, the last word is the quantity of a command. A command of the interface's own kind
is forwarded; any other needs a PID.

Source: forward_command_controller, effort_controllers and velocity_controllers of ros_controllers, texts.
"""

from __future__ import annotations

import math
import re
from typing import Any

from simkit.msgs import Time, message_class
from simkit.plugins.control.controller import Controller, InitError
from simkit.plugins.control.joint_drive import JointHandle, position_error
from simkit.plugins.control.limits import JointLimits, clamp
from simkit.plugins.control.pid import NO_GAIN, Pid, read_gains
from simkit.urdf import Joint, JointType

NO_GROUP_JOINT = "Exception thrown: Could not find resource '{joint}' in '{interface}'."
NO_JOINT = (
    "Exception thrown while initializing controller '{controller}'.\n"
    "Could not find resource '{joint}' in '{interface}'."
)
"""The error for a joint that is not there, or has another interface."""
STATE_EVERY = 10
"""A PID of one joint publishes one update of so many."""
_STATE = "control_msgs/JointControllerState"
_NAME = re.compile("Joint(Group)?(Position|Velocity|Effort)Controller")


class Forward:
    """The target of a joint is its command.

    Args:
        joint: The joint.
    """

    def __init__(self, joint: JointHandle) -> None:
        self.joint = joint

    def reset(self) -> None:
        """Nothing is remembered."""

    def command(self, target: float, period_s: float) -> None:  # noqa: ARG002 - the form of PidLaw
        """Forward the target."""
        self.joint.command = target


class PidLaw:
    """A PID brings a joint to a velocity.

    Args:
        joint: The joint.
        pid: Its gains and past errors.
    """

    def __init__(self, joint: JointHandle, pid: Pid) -> None:
        self.joint = joint
        self.pid = pid
        self.report: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 0.0)
        """Target, error, period [s] and command of the last update."""

    def reset(self) -> None:
        """Forget past errors."""
        self.pid.reset()

    def command(self, target: float, period_s: float) -> None:
        """Command what makes the error small."""
        target, error, rate = self.error(target)
        self.joint.command = self.pid.command(error, period_s, rate=rate)
        self.report = (target, error, period_s, self.joint.command)

    def error(self, target: float) -> tuple[float, float, float | None]:
        """The target that is possible, how far it is to it, and how fast this grows if that is known."""
        return target, target - self.joint.velocity, None

    @property
    def process_value(self) -> tuple[float, float]:
        """What is controlled, and its rate of change; ros_controllers publish the effort for a velocity's."""
        return self.joint.velocity, self.joint.effort


class PositionPidLaw(PidLaw):
    """A PID brings a joint to a position, the way that the URDF allows.

    Args:
        joint: The joint.
        pid: Its gains and past errors.
        urdf: The joint in the URDF.
    """

    def __init__(self, joint: JointHandle, pid: Pid, urdf: Joint) -> None:
        super().__init__(joint, pid)
        self._kind = urdf.type
        self._limits = JointLimits()
        if urdf.limit is not None and urdf.type in (JointType.REVOLUTE, JointType.PRISMATIC):
            self._limits = JointLimits(lower=urdf.limit.lower, upper=urdf.limit.upper)

    def error(self, target: float) -> tuple[float, float, float | None]:
        """The target within the limits, how far it is to it, and how fast this grows."""
        target = clamp(target, self._limits.lower, self._limits.upper)
        error = position_error(self._kind, self.joint.position, target, self._limits)
        return target, error, 0.0 - self.joint.velocity

    @property
    def process_value(self) -> tuple[float, float]:
        """Position and velocity of the joint."""
        return self.joint.position, self.joint.velocity


class JointCommandController(Controller):
    """The controller: one joint listens to std_msgs/Float64, a group to std_msgs/Float64MultiArray.

    It begins with the positions that the joints have, or with velocities or efforts of 0. One joint with
    a PID publishes control_msgs/JointControllerState on the topic state.
    """

    def init(self) -> None:
        """Take the joints, and the gains if it needs them.

        Raises:
            InitError: It has no joint or no gains, or the URDF does not have the joint.
        """
        found = _NAME.fullmatch(self.type.bare_name)
        assert found is not None
        self._is_group, self._quantity = found[1] is not None, found[2]
        self._forwards = self.type.interface.startswith(self._quantity)
        self.claims = self._group_names() if self._is_group else (self._joint_name(),)
        self._laws = [self._law(name) for name in self.claims]
        self._targets = [0.0] * len(self._laws)
        self._updates = 0
        self._publishes = not self._is_group and not self._forwards
        if self._publishes:
            self._state = self.advertise("state", message_class(_STATE))
        kind = "std_msgs/Float64MultiArray" if self._is_group else "std_msgs/Float64"
        self.subscribe("command", message_class(kind), self._on_command)

    def starting(self, time_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Hold the joints where they are, or do nothing until there is a command."""
        self._updates = 0
        for number, law in enumerate(self._laws):
            law.reset()
            self._targets[number] = law.joint.position if self._quantity == "Position" else 0.0

    def update(self, time_ns: int, period_ns: int) -> None:  # noqa: ARG002 - the form of Controller
        """Command the joints."""
        self._updates += 1
        for law, target in zip(self._laws, self._targets, strict=True):
            law.command(target, period_ns * 1e-9)

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - the form of Controller
        """One update in ten."""
        return self._publishes and self._updates % STATE_EVERY == 1

    def publish(self, time_ns: int) -> None:
        """Publish what is wanted, and what is."""
        (law,) = self._laws
        assert isinstance(law, PidLaw)
        message: Any = message_class(_STATE)()
        gains = law.pid.gains
        message.header.stamp = Time.from_nsec(time_ns)
        message.set_point, message.error, message.time_step, message.command = law.report
        message.process_value, message.process_value_dot = law.process_value
        message.p, message.i, message.d = gains.p, gains.i, gains.d
        message.i_clamp, message.antiwindup = gains.i_max, gains.antiwindup
        self._state.publish(message)

    def _law(self, name: str) -> Forward | PidLaw:
        # The words of the first fault are those of the original: one joint asks for its gains first.
        pid = None if self._forwards or self._is_group else self._pid("pid")
        joint = self.joint(name, NO_GROUP_JOINT if self._is_group else NO_JOINT)
        if self._forwards:
            return Forward(joint)
        if self._quantity == "Velocity":
            return PidLaw(joint, pid or self._pid(f"{name}/pid"))
        urdf = self._urdf_joint(name)
        return PositionPidLaw(joint, pid or self._pid(f"{name}/pid"), urdf)

    def _joint_name(self) -> str:
        name = self.parameter("joint")
        if not isinstance(name, str) or not name:
            interface = self.type.interface
            joints = ", ".join(self.hardware.joints_of(interface)) or "none"
            raise InitError(
                f"No joint given (namespace: {self.namespace})",
                hint=f"write joint: ... in the YAML file; joints with a {interface}: {joints}",
            )
        return name

    def _group_names(self) -> tuple[str, ...]:
        if self.parameter("joints") is None:
            raise InitError(
                f"Failed to getParam 'joints' (namespace: {self.namespace}).",
                hint="write joints: [hip, shoulder] in the YAML file",
            )
        return self.joint_names()

    def _pid(self, key: str) -> Pid:
        namespace = f"{self.namespace}/{key}"
        gains = read_gains(self.node.graph.params, namespace)
        if gains is None:
            raise InitError(
                NO_GAIN.format(namespace=namespace),
                hint=f"{self.type.name} makes commands by gains: add {key.replace('/', ': {')}: "
                f"{{p: 100.0, i: 0.01, d: 10.0}}{'}' * key.count('/')} in the YAML file, and try out the "
                "numbers",
            )
        return Pid(gains)

    def _urdf_joint(self, name: str) -> Joint:
        found = self.robot().joints.get(name)
        if found is None:
            raise InitError(f"Could not find joint '{name}' in urdf")
        return found

    def _on_command(self, message: Any) -> None:
        targets = list(message.data) if self._is_group else [message.data]
        if len(targets) != len(self.claims):
            self.node.error(
                f"Dimension of command ({len(targets)}) does not match number of joints "
                f"({len(self.claims)})! Not executing!"
            )
            self.node.warn(f"hint: data must have one number for each of {', '.join(self.claims)}")
            return
        for target in targets:
            if not math.isfinite(target):
                self.node.error(
                    f"{self.namespace}/command says {target}, which is no number: not executing"
                )
                return
        self._targets = targets
