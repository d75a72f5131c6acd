"""One joint with a motor: how its state is read, and how a command becomes a motion.

Source: gazebo_ros_control `DefaultRobotHWSim`: `readSim`, `writeSim`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.physics import ModelJoint
from simkit.physics.joint import FARTHEST, STRONGEST
from simkit.plugins.control.angles import (
    ContinuousAngle,
    distance_within_limits,
    shortest_angular_distance,
)
from simkit.plugins.control.limits import JointLimits, Limiter, clamp
from simkit.plugins.control.pid import Pid
from simkit.plugins.control.registry import EFFORT, POSITION, VELOCITY
from simkit.urdf import JointType


@dataclass(slots=True)
class JointHandle:
    """What controllers see of a joint: its state, and a command that they may write."""

    name: str
    """Name of the joint."""
    interface: str
    """How it is commanded: `PositionJointInterface` and the like."""
    position: float = 0.0
    """[rad or m]."""
    velocity: float = 0.0
    """[rad/s or m/s]."""
    effort: float = 0.0
    """What its motor did [N m or N]."""
    command: float = 0.0
    """Position, velocity or effort, by the interface."""


class JointDrive:
    """A joint with a motor.

    Args:
        joint: The joint in the world.
        interface: How it is commanded.
        kind: How it moves; None if the URDF does not know it.
        limits: Its limits; None if there are none.
        pid: Gains with which a position or velocity becomes an effort; None where it simply is as commanded.
    """

    def __init__(
        self,
        joint: ModelJoint,
        interface: str,
        *,
        kind: JointType | None = None,
        limits: JointLimits | None = None,
        pid: Pid | None = None,
    ) -> None:
        self.handle = JointHandle(joint.name, interface)
        self.limits = limits or JointLimits()
        self.pid = pid
        self._joint = joint
        self._kind = kind
        self._limiter = None if limits is None else Limiter(limits)
        self._angle = None if kind is JointType.PRISMATIC else ContinuousAngle()
        self._kept: float | None = None

    def read(self) -> None:
        """Read position, velocity and effort of the joint."""
        handle, position = self.handle, self._joint.position
        handle.position = position if self._angle is None else self._angle.read(position)
        handle.velocity = self._joint.velocity
        handle.effort = self._joint.effort

    def write(self, period_s: float, *, is_stopped: bool = False) -> None:
        """Carry the command out.

        Args:
            period_s: Time since it was done last [s].
            is_stopped: Whether the emergency stop is on: positions stay, velocities and efforts are 0.
        """
        handle = self.handle
        self._keep(is_stopped=is_stopped)
        if self._limiter is not None:
            handle.command = self._limited(self._limiter, period_s)
        command = 0.0 if is_stopped and handle.interface != POSITION else handle.command
        if not math.isfinite(command):
            return  # what is no number is no command: the last one holds
        command = clamp(command, -FARTHEST, FARTHEST)
        if handle.interface == EFFORT:
            self._joint.command_effort(command)
        elif self.pid is not None:
            self._push(self._error(command), period_s)
        elif handle.interface == POSITION:
            self._joint.command_position(clamp(command, self.limits.lower, self.limits.upper))
        else:
            most = self.limits.effort
            self._joint.command_velocity(command, effort=most if math.isfinite(most) else None)

    def release(self) -> None:
        """Let the joint go."""
        self._joint.release()

    def _keep(self, *, is_stopped: bool) -> None:
        if not is_stopped:
            self._kept = None
        elif self.handle.interface == POSITION:
            if self._kept is None:
                self._kept = self.handle.position
            self.handle.command = self._kept

    def _limited(self, limiter: Limiter, period_s: float) -> float:
        handle = self.handle
        command, position = handle.command, handle.position
        if handle.interface == POSITION:
            return limiter.position(command, position=position, period_s=period_s)
        if handle.interface == VELOCITY:
            return limiter.velocity(command, position=position, period_s=period_s)
        return limiter.effort(command, position=position, velocity=handle.velocity)

    def _error(self, command: float) -> float:
        handle, limits = self.handle, self.limits
        if handle.interface == VELOCITY:
            return command - handle.velocity
        return position_error(self._kind, handle.position, command, limits)

    def _push(self, error: float, period_s: float) -> None:
        assert self.pid is not None
        most = min(self.limits.effort, STRONGEST)
        effort = self.pid.command(error, period_s)
        if math.isfinite(effort):
            self._joint.command_effort(clamp(effort, -most, most))


def position_error(
    kind: JointType | None, position: float, command: float, limits: JointLimits
) -> float:
    """How far it is to a position, the way that the joint would go [rad or m]."""
    if kind is JointType.REVOLUTE:
        return distance_within_limits(position, command, limits.lower, limits.upper)
    if kind is JointType.CONTINUOUS:
        return shortest_angular_distance(position, command)
    return command - position
