"""A new command in the middle of a trajectory: what is left of the old one, a bridge, and the new one.

Source: `initJointTrajectory` of joint_trajectory_controller.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from simkit.plugins.control.angles import wraparound_offset
from simkit.plugins.control.trajectory.command import (
    TrajectoryCommand,
    check_point,
    check_times,
    late_text,
    map_joints,
)
from simkit.plugins.control.trajectory.segment import (
    MotionSegment,
    Trajectory,
    find_segment,
    sample,
    segment_between,
)
from simkit.plugins.control.trajectory.settings import ControlledJoints


@dataclass(frozen=True, slots=True, kw_only=True)
class Instant:
    """One moment on two clocks."""

    time_ns: int
    """Virtual time, in which commands have their stamps [ns]."""
    uptime_ns: int
    """Time since the controller was started, in which trajectories run [ns]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Replacement:
    """What becomes of a trajectory."""

    trajectories: tuple[Trajectory, ...]
    """One for each joint of the controller."""
    dropped: int = 0
    """So many points at the beginning were past."""
    first_in_s: float = 0.0
    """When the first of the others is reached, from now [s]."""


def replace_trajectories(
    current: Sequence[Trajectory],
    command: TrajectoryCommand,
    joints: ControlledJoints,
    now: Instant,
    *,
    goal: object | None = None,
) -> Replacement:
    """Follow a command from where the joints are meant to be.

    What runs goes on until the command starts. From the state that is desired then, whatever the
    joints really do, a bridge leads to the first point that is not past.

    Args:
        current: What the joints follow now, one trajectory for each.
        command: What they shall follow; it has at least one point.
        joints: The joints.
        now: The next moment at which the controller works.
        goal: The goal of an action that the command comes from.

    Raises:
        TrajectoryRefused: It cannot be followed; nothing has changed.
    """
    check_times(command)
    places = map_joints(command, joints.names, allow_partial=joints.allow_partial)
    first, dropped = _first_point(command, now)
    for number in range(first, len(command.points)):
        check_point(command, number)
    result = [_continued(one, now, goal) for one in current]
    for number, place in enumerate(places):
        result[place] = _replaced(current[place], command, number, first, now, goal, joints, place)
    start_ns = command.stamp_ns or now.time_ns
    reached_ns = start_ns + command.points[first].time_ns - now.time_ns
    return Replacement(trajectories=tuple(result), dropped=dropped, first_in_s=reached_ns / 1e9)


def _first_point(command: TrajectoryCommand, now: Instant) -> tuple[int, int]:
    """Number of the first point that is still to come, and how many before it are worth a word."""
    start_ns = command.stamp_ns or now.time_ns
    past = sum(start_ns + point.time_ns <= now.time_ns for point in command.points)
    if past == len(command.points):
        raise late_text(command, now.time_ns - start_ns - command.points[-1].time_ns)
    is_silent = past == 1 and command.stamp_ns == 0 and command.points[0].time_ns == 0
    return past, 0 if is_silent else past


def _continued(current: Trajectory, now: Instant, goal: object | None) -> Trajectory:
    """What is left of a trajectory, for a goal that does not name its joint."""
    left = current[max(0, find_segment(current, now.uptime_ns)) :]
    return tuple(replace(segment, goal=goal) for segment in left)


def _replaced(
    current: Trajectory,
    command: TrajectoryCommand,
    number: int,
    first: int,
    now: Instant,
    goal: object | None,
    joints: ControlledJoints,
    place: int,
) -> Trajectory:
    start_ns = now.uptime_ns + (command.stamp_ns or now.time_ns) - now.time_ns
    bridge_ns = max(start_ns, now.uptime_ns)
    state = sample(current, bridge_ns)
    point = command.points[first]
    offset = 0.0
    if joints.turns[place]:
        offset = wraparound_offset(state.position, point.positions[number])
    tolerances = joints.tolerances[place]
    last = find_segment(current, bridge_ns)
    segments: list[MotionSegment] = list(
        current[max(0, find_segment(current, now.uptime_ns)) : last + 1]
    )
    begin_ns, begin = bridge_ns, state.knot()
    for point in command.points[first:]:
        end_ns, end = start_ns + point.time_ns, point.knot(number, offset)
        segments.append(
            segment_between(begin_ns, begin, end_ns, end, goal=goal, tolerances=tolerances)
        )
        begin_ns, begin = end_ns, end
    return tuple(segments)
