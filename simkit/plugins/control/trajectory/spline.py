"""Polynomials between two states of a joint: straight lines, cubics, quintics.

Source: `trajectory_interface::QuinticSplineSegment` of joint_trajectory_controller.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Knot:
    """Where a joint shall be, and if it is said, how it moves there."""

    position: float
    """[rad or m]."""
    velocity: float | None = None
    """[rad/s or m/s]."""
    acceleration: float | None = None
    """[rad/s^2 or m/s^2]."""


@dataclass(frozen=True, slots=True)
class State:
    """Where a joint is and how it moves."""

    position: float = 0.0
    """[rad or m]."""
    velocity: float = 0.0
    """[rad/s or m/s]."""
    acceleration: float = 0.0
    """[rad/s^2 or m/s^2]."""

    def knot(self) -> Knot:
        """The same as the end of a spline."""
        return Knot(position=self.position, velocity=self.velocity, acceleration=self.acceleration)


@dataclass(frozen=True, slots=True)
class Spline:
    """A polynomial of time."""

    coefficients: tuple[float, ...]
    """Of the powers 0, 1, 2, ... of the time [s]."""

    def at(self, time_s: float) -> State:
        """The state at a time since its beginning [s]."""
        position = velocity = acceleration = 0.0
        for coefficient in reversed(self.coefficients):
            acceleration = acceleration * time_s + 2.0 * velocity
            velocity = velocity * time_s + position
            position = position * time_s + coefficient
        return State(position, velocity, acceleration)


def spline_between(start: Knot, end: Knot, duration_s: float) -> Spline:
    """The polynomial of lowest order that has all that both ends say.

    Positions give a straight line, velocities as well a cubic, accelerations as well a quintic. What
    only one of the ends says does not count.

    Args:
        start: At the beginning.
        end: At the end.
        duration_s: Time between them [s]; with 0 it stays as it starts.
    """
    has_velocities = start.velocity is not None and end.velocity is not None
    has_accelerations = start.acceleration is not None and end.acceleration is not None
    if not has_velocities:
        return _line(start.position, end.position, duration_s)
    if not has_accelerations:
        return _cubic(start, end, duration_s)
    return _quintic(start, end, duration_s)


def _line(p0: float, p1: float, t: float) -> Spline:
    return Spline((p0, (p1 - p0) / t if t > 0.0 else 0.0))


def _cubic(start: Knot, end: Knot, t: float) -> Spline:
    p0, p1, v0, v1 = start.position, end.position, start.velocity or 0.0, end.velocity or 0.0
    if t <= 0.0:
        return Spline((p0, v0))
    c2 = (3.0 * (p1 - p0) - (2.0 * v0 + v1) * t) / t**2
    c3 = (2.0 * (p0 - p1) + (v0 + v1) * t) / t**3
    return Spline((p0, v0, c2, c3))


def _quintic(start: Knot, end: Knot, t: float) -> Spline:
    p0, p1, v0, v1 = start.position, end.position, start.velocity or 0.0, end.velocity or 0.0
    a0, a1 = start.acceleration or 0.0, end.acceleration or 0.0
    if t <= 0.0:
        return Spline((p0, v0, 0.5 * a0))
    way = p1 - p0
    c3 = (20.0 * way - (8.0 * v1 + 12.0 * v0) * t - (3.0 * a0 - a1) * t**2) / (2.0 * t**3)
    c4 = (-30.0 * way + (14.0 * v1 + 16.0 * v0) * t + (3.0 * a0 - 2.0 * a1) * t**2) / (2.0 * t**4)
    c5 = (12.0 * way - 6.0 * (v1 + v0) * t - (a0 - a1) * t**2) / (2.0 * t**5)
    return Spline((p0, v0, 0.5 * a0, c3, c4, c5))
