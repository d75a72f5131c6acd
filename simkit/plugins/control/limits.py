"""Limits of joints: what a command may be, and what is made of one that is beyond.

Source: joint_limits_interface: `joint_limits_urdf.h`, `joint_limits_rosparam.h`, `joint_limits_interface.h`.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from simkit.urdf import Joint, JointType, Safety


@dataclass(frozen=True, slots=True, kw_only=True)
class JointLimits:
    """How far, how fast, how strong; infinite where there is no limit."""

    lower: float = -math.inf
    """Smallest position [rad or m]."""
    upper: float = math.inf
    """Largest position [rad or m]."""
    velocity: float = math.inf
    """Largest speed [rad/s or m/s]."""
    acceleration: float = math.inf
    """Largest change of speed [rad/s^2 or m/s^2]."""
    effort: float = math.inf
    """Largest torque or force [N m or N]."""
    soft: Safety | None = None
    """Limits within the limits, towards which it slows down."""


def limits_of(joint: Joint | None, parameters: Mapping[str, Any]) -> JointLimits | None:
    """The limits of a joint; None if nobody gives any.

    Args:
        joint: The joint in the URDF; None if it is not there.
        parameters: What the parameter `joint_limits/<joint>` holds; it overrides the URDF.
    """
    limits = None if joint is None or joint.limit is None else _from_urdf(joint)
    if not parameters:
        return limits
    return _from_parameters(limits or JointLimits(), parameters)


def _from_urdf(joint: Joint) -> JointLimits:
    assert joint.limit is not None
    found = JointLimits(
        velocity=abs(joint.limit.velocity), effort=abs(joint.limit.effort), soft=joint.safety
    )
    if joint.type in (JointType.REVOLUTE, JointType.PRISMATIC):
        found = replace(found, lower=joint.limit.lower, upper=joint.limit.upper)
    return found


def _from_parameters(limits: JointLimits, given: Mapping[str, Any]) -> JointLimits:
    if given.get("has_position_limits") is False:
        limits = replace(limits, lower=-math.inf, upper=math.inf)
    elif given.get("has_position_limits"):
        lower, upper = _number(given, "min_position"), _number(given, "max_position")
        if lower is not None and upper is not None:
            limits = replace(limits, lower=lower, upper=upper)
    return replace(
        limits,
        velocity=_largest(limits.velocity, given, "velocity"),
        acceleration=_largest(limits.acceleration, given, "acceleration"),
        effort=_largest(limits.effort, given, "effort"),
    )


def _largest(value: float, given: Mapping[str, Any], kind: str) -> float:
    if given.get(f"has_{kind}_limits") is False:
        return math.inf
    found = _number(given, f"max_{kind}") if given.get(f"has_{kind}_limits") else None
    return value if found is None else abs(found)


def _number(given: Mapping[str, Any], key: str) -> float | None:
    """A parameter that is a number; None if it is missing or not finite."""
    value = given.get(key)
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return None
    return float(value)


def clamp(value: float, lower: float, upper: float) -> float:
    """The nearest number within two ends."""
    return min(max(value, lower), upper)


class Limiter:
    """Keeps the commands of one joint within its limits.

    Args:
        limits: Its limits.
    """

    def __init__(self, limits: JointLimits) -> None:
        self.limits = limits
        self._last: float | None = None

    def position(self, command: float, *, position: float, period_s: float) -> float:
        """The position that may be commanded: within the limits, and no faster than they say [rad or m]."""
        limits = self.limits
        last = position if self._last is None else self._last
        slowest, fastest = self._soft_speeds(last)
        command = clamp(
            command,
            max(last + slowest * period_s, limits.lower),
            min(last + fastest * period_s, limits.upper),
        )
        self._last = command
        return command

    def velocity(self, command: float, *, position: float, period_s: float) -> float:
        """The speed that may be commanded [rad/s or m/s]."""
        slowest, fastest = self._soft_speeds(position)
        last = self._last or 0.0
        change = self.limits.acceleration * period_s
        command = clamp(command, max(slowest, last - change), min(fastest, last + change))
        self._last = command
        return command

    def effort(self, command: float, *, position: float, velocity: float) -> float:
        """The torque or force that may be commanded: none that drives it on beyond a limit [N m or N]."""
        limits, most = self.limits, self.limits.effort
        if limits.soft is not None:
            slowest, fastest = self._soft_speeds(position)
            stiffness = limits.soft.k_velocity
            least = clamp(-stiffness * (velocity - slowest), -most, most)
            return clamp(command, least, clamp(-stiffness * (velocity - fastest), -most, most))
        is_low = position < limits.lower or velocity < -limits.velocity
        is_high = position > limits.upper or velocity > limits.velocity
        return clamp(command, 0.0 if is_low else -most, 0.0 if is_high else most)

    def _soft_speeds(self, position: float) -> tuple[float, float]:
        limits = self.limits
        soft, most = limits.soft, limits.velocity
        if soft is None or not math.isfinite(limits.lower):
            return -most, most
        return (
            clamp(-soft.k_position * (position - soft.soft_lower), -most, most),
            clamp(-soft.k_position * (position - soft.soft_upper), -most, most),
        )
