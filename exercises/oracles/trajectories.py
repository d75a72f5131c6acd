"""Trajectories that a student's node sends: what they ask for, whether that can be, and whether it was done."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from grader.checks.expect import expect_close
from grader.checks.log import with_complaint
from grader.errors import CheckFailed
from oracles.driven_arm import COMMAND, DrivenArm

_TYPE = "trajectory_msgs/JointTrajectory"
_SLACK = 1e-6
"""Rounding of angles and times."""
_LATE = 0.25
"""A trajectory may be so much too early or too late [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Rules:
    """What each trajectory must keep to."""

    limits: Mapping[str, tuple[float, float]]
    """The lowest and the highest angle of each joint [rad]."""
    longest: float
    """The last point comes at most so long after the start [s]."""
    every: float
    """Time from one trajectory to the next [s]."""


def watch(arm: DrivenArm, seconds: float, rules: Rules) -> list[tuple[float, Any]]:
    """Let time pass; each trajectory that is sent meanwhile must be sound, and the arm must have done it.

    Args:
        arm: The robot.
        seconds: How long [s].
        rules: What the trajectories must keep to.

    Returns:
        The messages with the times at which they came, counted from now [s].

    Raises:
        CheckFailed: One is unsound, comes before the one before it is done, or was not done.
    """
    sim = arm.sim
    begin = sim.now.to_sec()
    heard = sim.record({COMMAND: _TYPE})
    waiting: list[tuple[float, dict[str, float]]] = []
    times: list[float] = []
    while (now := sim.now.to_sec() - begin) < seconds - 1e-9:
        sim.run(min(0.05, seconds - now))
        for stamp, message in heard[COMMAND][len(times) :]:
            end = expect_sound(message, rules)
            times.append(stamp.to_sec() - begin)
            _expect_in_time(times, rules.every)
            waiting.append((times[-1] + rules.longest + 0.05, end))
        while waiting and sim.now.to_sec() - begin >= waiting[0][0]:
            _expect_done(arm, waiting.pop(0)[1])
    heard.stop()
    return list(zip(times, (message for _, message in heard[COMMAND]), strict=True))


def expect_sound(message: Any, rules: Rules) -> dict[str, float]:
    """Expect a trajectory that a controller takes, with all joints within their limits; where it ends [rad].

    Raises:
        CheckFailed: Says which point, and which joint.
    """
    names = list(message.joint_names)
    if sorted(names) != sorted(rules.limits):
        raise CheckFailed(
            "a trajectory names other joints than the robot has",
            expected=", ".join(rules.limits),
            actual=", ".join(names) or "no joint",
            hint="joint_names must list each joint of the controller once, in any order.",
        )
    if len(message.points) < 2:
        raise CheckFailed(
            f"a trajectory has {len(message.points)} point{'s' * (len(message.points) != 1)}",
            expected="two points or more",
            hint="points is a list: append one JointTrajectoryPoint for each point of the trajectory.",
        )
    before = 0.0
    for number, point in enumerate(message.points):
        before = _expect_later(point, number, before, rules.longest)
        _expect_within(point, number, names, rules)
    return dict(zip(names, message.points[-1].positions, strict=True))


def _expect_in_time(times: list[float], every: float) -> None:
    if len(times) > 1:
        expect_close(
            times[-1] - times[-2],
            every,
            tolerance=_LATE,
            what="the time from one trajectory to the next",
            unit="s",
            hint=f"rospy.Rate takes a frequency: once in {every:g} s is 1/{every:g} Hz. rospy.sleep takes seconds.",
        )


def _expect_later(point: Any, number: int, before: float, longest: float) -> float:
    time = float(point.time_from_start.to_sec())
    if not before < time:
        raise CheckFailed(
            f"points[{number}] of a trajectory comes too early",
            expected=f"later than {before:g} s",
            actual=f"{time:g} s",
            hint="time_from_start is measured from the start of the whole trajectory. It must be greater than 0 for the "
            "first point, and for each further one greater than for the one before. It is a rospy.Duration.",
        )
    if time > longest + _SLACK:
        raise CheckFailed(
            f"points[{number}] of a trajectory comes too late",
            expected=f"at most {longest:g} s after the start",
            actual=f"{time:g} s",
            hint="The arm must have arrived before the next trajectory comes.",
        )
    return time


def _expect_within(point: Any, number: int, names: list[str], rules: Rules) -> None:
    if len(point.positions) != len(names):
        raise CheckFailed(
            f"points[{number}] of a trajectory has {len(point.positions)} positions for {len(names)} joints",
            hint="positions needs one number for each name in joint_names.",
        )
    for name, position in zip(names, point.positions, strict=True):
        low, high = rules.limits[name]
        if not low - _SLACK <= position <= high + _SLACK:
            raise CheckFailed(
                f"points[{number}] of a trajectory sends {name} beyond its limits",
                expected=f"from {low:g} to {high:g} rad",
                actual=f"{position:.3f} rad",
                hint="The first number in positions belongs to the first name in joint_names, and so on: are they in "
                "the same order? random.uniform(low, high) keeps within limits.",
            )


def _expect_done(arm: DrivenArm, end: Mapping[str, float]) -> None:
    joints = tuple(end)
    try:
        expect_close(
            arm.at(*joints),
            [end[name] for name in joints],
            tolerance=0.01,
            what=f"the angles of {', '.join(joints)} after a trajectory",
            unit="rad",
            hint="The controller may have refused the trajectory, or the next one came too soon and replaced it.",
        )
    except CheckFailed as failure:
        raise with_complaint(failure, arm.sim) from None
