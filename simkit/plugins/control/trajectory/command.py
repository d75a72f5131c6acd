"""What a trajectory command asks for, and why one is refused."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.errors import SimkitError
from simkit.plugins.control.trajectory.spline import Knot


class TrajectoryRefused(SimkitError):
    """A command cannot be followed.

    Args:
        text: Why, in the words of ros_controllers.
        hint: Which point, which joint, and what would be right.
        is_late: Whether all of it lies in the past, which is no fault of its form.
    """

    def __init__(self, text: str, *, hint: str = "", is_late: bool = False) -> None:
        super().__init__(text)
        self.hint = hint
        self.is_late = is_late


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """Where all joints shall be at a time; the numbers stand in the order of the command's joints."""

    positions: tuple[float, ...]
    """[rad or m]."""
    velocities: tuple[float, ...] = ()
    """[rad/s or m/s]; empty if they are not said."""
    accelerations: tuple[float, ...] = ()
    """[rad/s^2 or m/s^2]; empty if they are not said."""
    time_ns: int
    """Since the start of the trajectory [ns]."""

    def knot(self, joint: int, offset: float = 0.0) -> Knot:
        """What it says of the joint of that number, with an offset of its position [rad]."""
        return Knot(
            position=self.positions[joint] + offset,
            velocity=self.velocities[joint] if self.velocities else None,
            acceleration=self.accelerations[joint] if self.accelerations else None,
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class TrajectoryCommand:
    """A whole command."""

    joints: tuple[str, ...]
    """Names of the joints."""
    points: tuple[Point, ...]
    """Where they shall be, in the order of time."""
    stamp_ns: int = 0
    """When it starts [ns]; 0 for as soon as possible."""
