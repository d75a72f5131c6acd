"""What goes into a turtle and comes out of it: velocities, poses, readings."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.nodes.turtlesim.window import Point, Rgb


@dataclass(frozen=True, slots=True, kw_only=True)
class Velocity:
    """What a turtle is told to do, in its own frame: x ahead, y to its left."""

    x: float = 0.0
    """Ahead [m/s]."""
    y: float = 0.0
    """To the left [m/s]."""
    angular: float = 0.0
    """Counter-clockwise [rad/s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtlePose:
    """What turtlesim/Pose says: 32-bit values, y upwards from the lower left corner."""

    x: float
    """To the right [m]."""
    y: float
    """Upwards [m]."""
    theta: float
    """Heading, counter-clockwise from x, in [-pi, pi) [rad]."""
    linear_velocity: float
    """Speed, never negative [m/s]."""
    angular_velocity: float
    """Turning rate [rad/s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """What one update of a turtle gives the outside world."""

    pose: TurtlePose
    """Where it is now."""
    color: Rgb
    """Colour of the paper under its centre, before this update's line is drawn."""
    clamped_from: Point | None
    """Where it would be without the wall: x, y_down [m]; None when it met no wall."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PoseSample:
    """One entry of a turtle's history."""

    time_ns: int
    """Virtual time [ns]."""
    pose: TurtlePose
    """Pose from that time on, until the next entry."""
