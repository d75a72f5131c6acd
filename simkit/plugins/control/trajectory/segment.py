"""Segments: splines with a time, in a row for each joint."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from operator import attrgetter
from typing import TypeAlias

from simkit.plugins.control.trajectory.spline import Knot, Spline, State, spline_between
from simkit.plugins.control.trajectory.tolerances import NO_TOLERANCES, JointTolerances


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
    """What is looked at while that goal is followed."""

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
