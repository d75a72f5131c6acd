"""The action follow_joint_trajectory: one goal at a time, watched until it is reached, missed or given up.

Source: `JointTrajectoryController::goalCB`, `cancelCB`, `update`; realtime_tools `RealtimeServerGoalHandle`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from simkit.graph import Timer
from simkit.msgs import message_class
from simkit.plugins.control.action_server import ActionServer, ServerGoal
from simkit.plugins.control.controller import stamp
from simkit.plugins.control.place import ControllerPlace
from simkit.plugins.control.trajectory.reading import fill_states
from simkit.plugins.control.trajectory.segment import MotionSegment
from simkit.plugins.control.trajectory.spline import State

SUCCESSFUL, INVALID_GOAL, INVALID_JOINTS = 0, -1, -2
PATH_TOLERANCE_VIOLATED, GOAL_TOLERANCE_VIOLATED = -4, -5
"""Codes of control_msgs/FollowJointTrajectoryResult."""


@dataclass(slots=True, kw_only=True)
class _Watch:
    """A goal that is followed."""

    goal: ServerGoal
    timer: Timer
    feedback: Any = None
    verdict: Any = None
    """Its result, once it is known; it is told when the goal is looked at next."""


class Goals:
    """The goal that is followed.

    What becomes of it is found out in each update, and told at the rate action_monitor_rate.

    Args:
        place: The controller.
        server: The action's server.
        names: Names of the joints.
        monitor_rate: How often a second it is told [Hz].
    """

    def __init__(
        self,
        place: ControllerPlace,
        server: ActionServer,
        names: Sequence[str],
        monitor_rate: float,
    ) -> None:
        self._place = place
        self._server = server
        self._names = tuple(names)
        self._period_s = 1.0 / monitor_rate
        self._watch: _Watch | None = None
        self._active: ServerGoal | None = None
        self._done: set[str] = set()

    @property
    def active(self) -> ServerGoal | None:
        """The goal whose tolerances are looked at; None if there is none, or its end is found out."""
        return self._active

    def begin(self, goal: ServerGoal) -> None:
        """Follow a goal instead of the one before."""
        self.give_up()
        self._server.accept(goal)
        self._active = goal
        self._done = set()
        timer = self._place.create_timer(self._period_s, self._tell)
        self._watch = _Watch(goal=goal, timer=timer)

    def give_up(self) -> None:
        """Cancel the goal that is followed, if there is one."""
        goal, self._active = self._active, None
        if goal is not None:
            self._forget()
            self._server.cancel(goal)

    def look(
        self,
        segments: Sequence[MotionSegment],
        uptime_ns: int,
        errors: Sequence[State],
        last_ends_ns: Sequence[int],
    ) -> None:
        """Look whether the joints are where they should be.

        Args:
            segments: The segment that counts now, for each joint.
            uptime_ns: Now, on the clock of the trajectories [ns].
            errors: Desired minus actual, for each joint.
            last_ends_ns: When the whole trajectory of each joint ends [ns].
        """
        for name, segment, error, end_ns in zip(
            self._names, segments, errors, last_ends_ns, strict=True
        ):
            if self._active is None or segment.goal is not self._active:
                continue
            if uptime_ns < segment.end_ns:
                if not segment.tolerances.path.allows(error):
                    self._miss(PATH_TOLERANCE_VIOLATED, f"{name} path error {error.position:f}")
            elif segment.end_ns == end_ns:
                self._look_at_end(name, segment, error, uptime_ns)
        if self._active is not None and len(self._done) == len(self._names):
            self._decide(self._result(SUCCESSFUL, ""))

    def note(
        self,
        time_ns: int,
        desired: Sequence[State],
        actual: Sequence[State],
        error: Sequence[State],
    ) -> None:
        """Keep what is to be told of the goal, at a time [ns]."""
        if self._active is None or self._watch is None:
            return
        feedback: Any = message_class("control_msgs/FollowJointTrajectoryFeedback")()
        feedback.header.stamp, feedback.joint_names = stamp(time_ns), list(self._names)
        fill_states(feedback, desired, actual, error)
        self._watch.feedback = feedback

    def _look_at_end(self, name: str, segment: MotionSegment, error: State, uptime_ns: int) -> None:
        tolerances = segment.tolerances
        if tolerances.goal.allows(error):
            self._done.add(name)
        elif uptime_ns >= segment.end_ns + round(tolerances.goal_time_s * 1e9):
            self._miss(GOAL_TOLERANCE_VIOLATED, f"{name} goal error {error.position:f}")

    def _miss(self, code: int, text: str) -> None:
        self._decide(self._result(code, text))

    def _decide(self, result: Any) -> None:
        assert self._watch is not None
        self._watch.verdict = result
        self._active = None

    def _result(self, code: int, text: str) -> Any:
        result = self._server.result()
        result.error_code, result.error_string = code, text
        return result

    def _tell(self) -> None:
        """Tell how far the goal is."""
        watch = self._watch
        if watch is None:
            return
        if watch.verdict is None:
            if watch.feedback is not None:
                self._server.feed_back(watch.goal, watch.feedback)
            return
        self._forget()
        end = self._server.succeed if watch.verdict.error_code == SUCCESSFUL else self._server.abort
        end(watch.goal, watch.verdict)

    def _forget(self) -> None:
        if self._watch is not None:
            self._watch.timer.cancel()
            self._watch = None
