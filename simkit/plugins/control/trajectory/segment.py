"""Motions of one joint: polynomials between two states, and trajectories, which are such polynomials in a row.

Source: `trajectory_interface::QuinticSplineSegment` and `JointTrajectorySegment` of joint_trajectory_controller.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from operator import attrgetter
from typing import TypeAlias

from simkit.plugins.control.trajectory.settings import NO_TOLERANCES, JointTolerances


@dataclass(frozen=True, slots=True, kw_only=True)
class Knot:
    """Where a joint shall be, and how it moves there if that is given."""

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
    """The polynomial of lowest order through all that both ends give.

    Positions give a straight line, velocities as well a cubic, accelerations as well a quintic. What
    only one of the ends gives does not count.

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


@dataclass(frozen=True, slots=True, kw_only=True)
class MotionSegment:
    """The motion of one joint for a time; before and after it, the joint rests at its ends."""

    start_ns: int
    """When it begins, on the clock of the controller [ns]."""
    end_ns: int
    """When it ends [ns]."""
    spline: Spline
    """The motion, with the time since its beginning."""
    end_position: float
    """Where it ends [rad or m]."""
    goal: object | None = None
    """The goal of an action that it belongs to; None for a command."""
    tolerances: JointTolerances = NO_TOLERANCES
    """What is checked while that goal is followed."""

    def sample(self, time_ns: int) -> State:
        """The state at a time [ns]."""
        if time_ns < self.start_ns:
            return State(self.spline.coefficients[0])
        if time_ns > self.end_ns:
            return State(self.end_position)
        state = self.spline.at((time_ns - self.start_ns) * 1e-9)
        if time_ns == self.end_ns:  # without what is left of rounding
            return State(self.end_position, state.velocity, state.acceleration)
        return state


Trajectory: TypeAlias = tuple[MotionSegment, ...]
"""The motion of one joint: segments in the order of their beginnings; at least one."""

_start = attrgetter("start_ns")


def segment_between(
    start_ns: int,
    start: Knot,
    end_ns: int,
    end: Knot,
    *,
    goal: object | None = None,
    tolerances: JointTolerances = NO_TOLERANCES,
) -> MotionSegment:
    """A segment between two states at two times [ns]; the second is not before the first."""
    spline = spline_between(start, end, (end_ns - start_ns) * 1e-9)
    stays = end_ns <= start_ns
    return MotionSegment(
        start_ns=start_ns,
        end_ns=end_ns,
        spline=spline,
        end_position=start.position if stays else end.position,
        goal=goal,
        tolerances=tolerances,
    )


def find_segment(trajectory: Trajectory, time_ns: int) -> int:
    """Number of the segment that counts at a time [ns]: the last one that has begun; -1 if none has."""
    return bisect_right(trajectory, time_ns, key=_start) - 1


def sample(trajectory: Trajectory, time_ns: int) -> State:
    """The state at a time [ns]; before the beginning that of the beginning."""
    return trajectory[max(0, find_segment(trajectory, time_ns))].sample(time_ns)


def hold(position: float, time_ns: int) -> Trajectory:
    """Stay at a position [rad or m] from a time on [ns]."""
    here = State(position).knot()
    return (segment_between(time_ns, here, time_ns, here),)


def stop(state: State, time_ns: int, duration_ns: int) -> Trajectory:
    """Come to rest in a time.

    It ends in the middle of the motion that would come back to where it starts, with the velocity
    turned round, in twice the time: there the velocity is 0.

    Args:
        state: Where the joint is meant to be, and how it moves.
        time_ns: When it begins to stop [ns].
        duration_ns: How long it takes; more than 0 [ns].
    """
    start = Knot(position=state.position, velocity=state.velocity, acceleration=0.0)
    back = Knot(position=state.position, velocity=-state.velocity, acceleration=0.0)
    there_and_back = segment_between(time_ns, start, time_ns + 2 * duration_ns, back)
    end_ns = time_ns + duration_ns
    middle = there_and_back.sample(end_ns)
    return (segment_between(time_ns, start, end_ns, middle.knot()),)
