"""What goes into a turtle and comes out of it: velocities, its pen, poses, readings."""

from __future__ import annotations

from dataclasses import dataclass, replace

from simkit.nodes.turtlesim.window import Point, Rgb


@dataclass(frozen=True, slots=True, kw_only=True)
class Velocity:
    """The velocity that a turtle is commanded, in its own frame: x ahead, y to its left."""

    x: float = 0.0
    """Ahead [m/s]."""
    y: float = 0.0
    """To the left [m/s]."""
    angular: float = 0.0
    """Counter-clockwise [rad/s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TurtlePose:
    """The content of turtlesim/Pose: 32-bit values, y upwards from the lower left corner."""

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
class TurtleReading:
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Pen:
    """Colour, width and state of a pen; a new turtle's pen is this one's defaults."""

    color: Rgb = (179, 184, 255)
    """Colour of what it draws."""
    width: int = 3
    """Width of what it draws [px]."""
    is_down: bool = True
    """Whether it draws."""

    def lifted(self) -> Pen:
        """The same pen off the paper; colour and width stay."""
        return replace(self, is_down=False)


def new_pen(color: Rgb, width: int) -> Pen:
    """The pen that `set_pen` puts down.

    Args:
        color: Colour of what it draws.
        width: Width [px]; 0 means 1.

    Source:
        turtlesim `Turtle::setPenCallback`: a width of 0 leaves the 1 px of a new Qt pen.
    """
    return Pen(color=color, width=width or 1)
