"""How a trajectory moves the joints: by positions as they are, or by gains that make speeds or efforts.

Source: `hardware_interface_adapter.h` of joint_trajectory_controller, texts.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from simkit.plugins.control.interfaces import POSITION
from simkit.plugins.control.joint_drive import JointHandle
from simkit.plugins.control.pid import NO_GAIN, Gains, Pid, read_gains
from simkit.plugins.control.place import ControllerPlace
from simkit.plugins.control.trajectory.spline import State


class Adapter(Protocol):
    """Commands joints so that they follow what is desired."""

    def starting(self) -> None:
        """The controller begins to work."""

    def command(self, desired: Sequence[State], error: Sequence[State], period_s: float) -> None:
        """Command the joints; so much time has passed since the last time [s]."""


class PositionAdapter:
    """Commands the desired positions."""

    def __init__(self, joints: Sequence[JointHandle]) -> None:
        self._joints = joints

    def starting(self) -> None:
        """Stay where the joints are."""
        for joint in self._joints:
            joint.command = joint.position

    def command(self, desired: Sequence[State], error: Sequence[State], period_s: float) -> None:  # noqa: ARG002 - the form of Adapter
        """Forward the positions."""
        for joint, state in zip(self._joints, desired, strict=True):
            joint.command = state.position


class PidAdapter:
    """Commands speeds or efforts that make the error small."""

    def __init__(self, place: ControllerPlace, joints: Sequence[JointHandle]) -> None:
        self._joints = joints
        self._pids = [_pid(place, joint.name) for joint in joints]
        self._forward = [place.number(f"velocity_ff/{joint.name}", 0.0) for joint in joints]

    def starting(self) -> None:
        """Forget old errors."""
        for joint, pid in zip(self._joints, self._pids, strict=True):
            pid.reset()
            joint.command = 0.0

    def command(self, desired: Sequence[State], error: Sequence[State], period_s: float) -> None:
        """Make commands of the errors of position and velocity."""
        for number, joint in enumerate(self._joints):
            wrong = error[number]
            push = self._pids[number].command(wrong.position, period_s, rate=wrong.velocity)
            joint.command = desired[number].velocity * self._forward[number] + push


def make_adapter(place: ControllerPlace, joints: Sequence[JointHandle]) -> Adapter:
    """The adapter for the interface of a controller."""
    return PositionAdapter(joints) if place.interface == POSITION else PidAdapter(place, joints)


def _pid(place: ControllerPlace, joint: str) -> Pid:
    namespace = f"{place.namespace}/gains/{joint}"
    gains = read_gains(place.node.graph.params, namespace)
    if gains is None:
        place.node.error(NO_GAIN.format(namespace=namespace))
        place.node.warn("Failed to initialize PID gains from ROS parameter server.")
        place.node.warn(
            f"hint: {place.type_name} makes commands by gains, and {joint} has none: it gets no command; "
            f"write gains: {{{joint}: {{p: 100.0, i: 0.01, d: 10.0}}}} in the YAML file, and try out the "
            "numbers"
        )
    return Pid(gains or Gains(p=0.0))
