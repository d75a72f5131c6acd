"""How far a joint may be from where it should be, while a goal is followed.

Source: `tolerances.h` of joint_trajectory_controller.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from simkit.plugins.control.trajectory.spline import State


@dataclass(frozen=True, slots=True, kw_only=True)
class Tolerance:
    """Largest errors of a state; 0 for what is not looked at."""

    position: float = 0.0
    """[rad or m]."""
    velocity: float = 0.0
    """[rad/s or m/s]."""
    acceleration: float = 0.0
    """[rad/s^2 or m/s^2]."""

    def allows(self, error: State) -> bool:
        """Whether an error is within it."""
        return not (
            0.0 < self.position < abs(error.position)
            or 0.0 < self.velocity < abs(error.velocity)
            or 0.0 < self.acceleration < abs(error.acceleration)
        )

    def changed(self, *, position: float, velocity: float, acceleration: float) -> Tolerance:
        """This with what a goal says: a positive number counts, a negative one is none, 0 changes nothing."""
        return Tolerance(
            position=_changed(self.position, position),
            velocity=_changed(self.velocity, velocity),
            acceleration=_changed(self.acceleration, acceleration),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class JointTolerances:
    """The tolerances of one joint."""

    path: Tolerance = Tolerance()
    """On the way."""
    goal: Tolerance = Tolerance()
    """At the end."""
    goal_time_s: float = 0.0
    """How long it may take, after the end, to come within the tolerance there [s]."""

    def with_goal_time(self, goal_time_s: float) -> JointTolerances:
        """This with what a goal says of the time: a positive number counts, a negative one is 0."""
        return replace(self, goal_time_s=_changed(self.goal_time_s, goal_time_s))


NO_TOLERANCES = JointTolerances()
"""Nothing is looked at."""


def _changed(value: float, by: float) -> float:
    if by > 0.0:
        return by
    return 0.0 if by < 0.0 else value
