"""The action follow_joint_trajectory: one goal at a time, watched until it is reached, missed or given up.

Source: `JointTrajectoryController::goalCB`, `cancelCB`, `update`; realtime_tools `RealtimeServerGoalHandle`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from simkit.graph import Timer
from simkit.msgs import Time, message_class
from simkit.plugins.control.action_server import ActionServer, ServerGoal
from simkit.plugins.control.controller import Controller
from simkit.plugins.control.trajectory.command import (
    TrajectoryCommand,
    TrajectoryRefused,
    read_command,
)
from simkit.plugins.control.trajectory.segment import MotionSegment, State
from simkit.plugins.control.trajectory.settings import TrajectorySettings

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
    """Its result, once it is known; it is sent when the timer fires next."""


class Goals:
    """The action of a controller, and the goal that is followed.

    Each update checks it; feedback and result are sent at the rate action_monitor_rate.

    Args:
        controller: The controller.
        settings: Its parameters.
        follow: Follows the trajectory of a goal from now on; gives the refusal if it cannot.
        hold: Brings the joints to rest.
    """

    def __init__(
        self,
        controller: Controller,
        settings: TrajectorySettings,
        *,
        follow: Callable[[TrajectoryCommand, ServerGoal], TrajectoryRefused | None],
        hold: Callable[[], None],
    ) -> None:
        self._controller = controller
        self._names = settings.joints.names
        self._allow_partial = settings.joints.allow_partial
        self._period_s = 1.0 / settings.action_monitor_rate
        self._follow, self._hold = follow, hold
        self._watch: _Watch | None = None
        self._active: ServerGoal | None = None
        self._done: set[str] = set()
        self._server = ActionServer(
            controller,
            "follow_joint_trajectory",
            "control_msgs/FollowJointTrajectory",
            on_goal=self._on_goal,
            on_cancel=self._on_cancel,
        )

    @property
    def active(self) -> ServerGoal | None:
        """The goal whose tolerances are checked; None if there is none, or its result is known."""
        return self._active

    def give_up(self) -> None:
        """Cancel the goal that is followed, if there is one."""
        goal, self._active = self._active, None
        if goal is not None:
            self._forget()
            self._server.cancel(goal)

    def check(
        self,
        segments: Sequence[MotionSegment],
        uptime_ns: int,
        errors: Sequence[State],
        last_ends_ns: Sequence[int],
    ) -> None:
        """Check whether the joints are where they should be.

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
                    self._decide(PATH_TOLERANCE_VIOLATED, f"{name} path error {error.position:f}")
            elif segment.end_ns == end_ns:
                self._check_end(name, segment, error, uptime_ns)
        if self._active is not None and len(self._done) == len(self._names):
            self._decide(SUCCESSFUL, "")

    def keep_feedback(
        self,
        time_ns: int,
        desired: Sequence[State],
        actual: Sequence[State],
        error: Sequence[State],
    ) -> None:
        """Keep the feedback of the goal, at a time [ns]."""
        if self._active is None or self._watch is None:
            return
        feedback: Any = message_class("control_msgs/FollowJointTrajectoryFeedback")()
        feedback.header.stamp, feedback.joint_names = Time.from_nsec(time_ns), list(self._names)
        fill_states(feedback, desired, actual, error)
        self._watch.feedback = feedback

    def _on_goal(self, goal: ServerGoal) -> None:
        node = self._controller.node
        if not self._controller.is_running:
            node.error("Can't accept new action goals. Controller is not running.")
            self._server.reject(goal, self._result(INVALID_GOAL, ""))
            return
        command = read_command(goal.goal.trajectory)
        if not self._fits(command):
            node.error("Joints on incoming goal don't match the controller joints.")
            node.warn(f"hint: the controller moves: {', '.join(self._names)}")
            self._server.reject(goal, self._result(INVALID_JOINTS, ""))
            return
        refusal = self._follow(command, goal)
        if refusal is None:
            self._begin(goal)
        else:
            self._server.reject(goal, self._result(INVALID_GOAL, str(refusal)))

    def _on_cancel(self, goal: ServerGoal) -> None:
        if self._active is goal:
            self._hold()
            self.give_up()

    def _fits(self, command: TrajectoryCommand) -> bool:
        """Whether a goal names the right joints."""
        names = set(command.joints)
        is_whole = len(command.joints) == len(self._names)
        is_allowed = is_whole or (self._allow_partial and bool(names))
        return is_allowed and names <= set(self._names)

    def _begin(self, goal: ServerGoal) -> None:
        """Follow a goal instead of the one before."""
        self.give_up()
        self._server.accept(goal)
        self._active = goal
        self._done = set()
        timer = self._controller.create_timer(self._period_s, self._report)
        self._watch = _Watch(goal=goal, timer=timer)

    def _check_end(self, name: str, segment: MotionSegment, error: State, uptime_ns: int) -> None:
        tolerances = segment.tolerances
        if tolerances.goal.allows(error):
            self._done.add(name)
        elif uptime_ns >= segment.end_ns + round(tolerances.goal_time_s * 1e9):
            self._decide(GOAL_TOLERANCE_VIOLATED, f"{name} goal error {error.position:f}")

    def _decide(self, code: int, text: str) -> None:
        assert self._watch is not None
        self._watch.verdict = self._result(code, text)
        self._active = None

    def _result(self, code: int, text: str) -> Any:
        result = self._server.result()
        result.error_code, result.error_string = code, text
        return result

    def _report(self) -> None:
        """Send the feedback of the goal, or its result."""
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


def fill_states(
    message: Any, desired: Sequence[State], actual: Sequence[State], error: Sequence[State]
) -> None:
    """Write states into a message with the fields desired, actual and error."""
    message.desired.positions = [one.position for one in desired]
    message.desired.velocities = [one.velocity for one in desired]
    message.desired.accelerations = [one.acceleration for one in desired]
    for part, states in ((message.actual, actual), (message.error, error)):
        part.positions = [one.position for one in states]
        part.velocities = [one.velocity for one in states]
