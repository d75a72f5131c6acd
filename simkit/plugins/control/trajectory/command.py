"""What a trajectory command asks for, and a sentence for each that cannot be followed.

Source: `initJointTrajectory` and `joint_trajectory_msg_utils.h`, texts and order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError, near_names
from simkit.plugins.control.trajectory.segment import Knot

_JOINTS = "Cannot create trajectory from message. It does not contain the expected joints."
_TIMES = "Trajectory message contains waypoints that are not strictly increasing in time."
_SIZES = "Size mismatch in trajectory point position, velocity or acceleration data."
_EMPTY = "Quintic spline segment can't be constructed: Endpoint positions can't be empty."
LARGEST = 1e9
"""No position, velocity or acceleration of a command is larger [rad or m, and per second]."""


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
    """[rad/s or m/s]; empty if they are not given."""
    accelerations: tuple[float, ...] = ()
    """[rad/s^2 or m/s^2]; empty if they are not given."""
    time_ns: int
    """Since the start of the trajectory [ns]."""

    def knot(self, joint: int, offset: float = 0.0) -> Knot:
        """The knot of the joint of that number, with an offset of its position [rad]."""
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


def read_command(message: Any) -> TrajectoryCommand:
    """What a trajectory_msgs/JointTrajectory asks for."""
    return TrajectoryCommand(
        joints=tuple(message.joint_names),
        points=tuple(
            Point(
                positions=tuple(point.positions),
                velocities=tuple(point.velocities),
                accelerations=tuple(point.accelerations),
                time_ns=point.time_from_start.to_nsec(),
            )
            for point in message.points
        ),
        stamp_ns=message.header.stamp.to_nsec(),
    )


def check_times(command: TrajectoryCommand) -> None:
    """Refuse points that do not come one after the other.

    Raises:
        TrajectoryRefused: Says which point.
    """
    for number in range(1, len(command.points)):
        before, after = command.points[number - 1].time_ns, command.points[number].time_ns
        if after <= before:
            raise TrajectoryRefused(
                _TIMES,
                hint=f"points[{number}] comes at {after / 1e9:g} s, and points[{number - 1}] at "
                f"{before / 1e9:g} s: each time_from_start is counted from the start of the whole "
                "trajectory, and must be later than the one before",
            )


def map_joints(
    command: TrajectoryCommand, joints: Sequence[str], *, allow_partial: bool
) -> tuple[int, ...]:
    """For each joint of a command, its number among those of the controller.

    Args:
        command: The command.
        joints: Names of the controller's joints.
        allow_partial: Whether a command may leave out some.

    Raises:
        TrajectoryRefused: Says which joint.
    """
    known = ", ".join(joints)
    for number, name in enumerate(command.joints):
        if name not in joints:
            near = near_names(name, joints)
            meant = f"; did you mean {near[0]!r}?" if near else "."
            raise TrajectoryRefused(
                _JOINTS, hint=f"joint_names has {name!r}{meant} The controller moves: {known}"
            )
        if name in command.joints[:number]:
            raise TrajectoryRefused(_JOINTS, hint=f"joint_names has {name!r} twice")
    missing = [name for name in joints if name not in command.joints]
    if missing and (not allow_partial or not command.joints):
        raise TrajectoryRefused(
            _JOINTS,
            hint=f"joint_names lacks {', '.join(missing)}: name all joints of the controller, in any "
            "order, or set its parameter allow_partial_joints_goal to true",
        )
    return tuple(list(joints).index(name) for name in command.joints)


def check_point(command: TrajectoryCommand, number: int) -> None:
    """Refuse a point that has not one number for each joint.

    Raises:
        TrajectoryRefused: Says which point, and of what it has too many or too few.
    """
    point, wanted = command.points[number], len(command.joints)
    names = ", ".join(command.joints)
    if not (point.positions or point.velocities or point.accelerations):
        raise TrajectoryRefused(
            _EMPTY, hint=f"points[{number}] has no positions: give one for each of {names}"
        )
    for kind, values in _values(point):
        if len(values) != wanted and (values or kind == "positions"):
            raise TrajectoryRefused(
                _SIZES,
                hint=f"points[{number}].{kind} has {len(values)} "
                f"number{'' if len(values) == 1 else 's'}, and joint_names has {wanted} "
                f"joint{'' if wanted == 1 else 's'}: give one number for each of {names}",
            )
        for name, value in zip(command.joints, values, strict=False):
            if not abs(value) <= LARGEST:
                raise TrajectoryRefused(
                    f"Trajectory message contains {value} in points[{number}].{kind}, for {name}.",
                    hint=f"every number must be finite, and at most {LARGEST:g}",
                )


def late_text(command: TrajectoryCommand, late_ns: int) -> TrajectoryRefused:
    """The refusal of a command of which every point is past, the last one by so much [ns]."""
    text = (
        f"Dropping all {len(command.points)} trajectory point(s), as they occur before the current "
        f"time.\nLast point is {late_ns / 1e9:f}s in the past."
    )
    hint = (
        f"header.stamp is {command.stamp_ns / 1e9:g} s, and the trajectory is over: leave the stamp "
        "at 0 to start at once"
    )
    if command.stamp_ns == 0:
        hint = (
            f"time_from_start is {command.points[-1].time_ns / 1e9:g} s: it says when the joints shall "
            "be there, counted from now, and must be greater than 0"
        )
    return TrajectoryRefused(text, hint=hint, is_late=True)


def _values(point: Point) -> list[tuple[str, tuple[float, ...]]]:
    return [
        ("positions", point.positions),
        ("velocities", point.velocities),
        ("accelerations", point.accelerations),
    ]
