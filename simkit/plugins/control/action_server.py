"""The server's side of an action: goals come and are cancelled; status, feedback and results go.

Source: actionlib `ActionServerBase`, `ActionServer`, `ServerGoalHandle`: topics, order, texts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from simkit.msgs import Time, message_class
from simkit.plugins.control.controller import Controller

PENDING, ACTIVE, PREEMPTED, SUCCEEDED, ABORTED, REJECTED, PREEMPTING, RECALLING, RECALLED = range(9)
"""States of a goal, of actionlib_msgs/GoalStatus."""
STATUS_SECONDS = 0.2
"""How often the status of all goals is published [s]."""
KEEP_NS = 5_000_000_000
"""How long a goal that has ended is still listed [ns]."""
_ENDED = (PREEMPTED, SUCCEEDED, ABORTED, REJECTED, RECALLED)
_EARLY = (
    "This goal handle was canceled by the action server because its timestamp is before the "
    "timestamp of the last cancel request"
)


@dataclass(slots=True, eq=False, kw_only=True)
class ServerGoal:
    """One goal; compared by identity."""

    goal_id: Any
    """actionlib_msgs/GoalID."""
    goal: Any
    """What is asked for; None of a goal that was cancelled before it came."""
    status: int = PENDING
    """How far it is."""
    text: str = ""
    """Why, if it ended otherwise than wished."""
    ended_ns: int = 0
    """When it ended [ns]."""

    @property
    def is_running(self) -> bool:
        """Whether it was accepted, and has not ended."""
        return self.status in (ACTIVE, PREEMPTING)


class ActionServer:
    """The server of one action.

    Args:
        controller: The controller that offers it.
        name: Name of the action, also that of its topics' namespace.
        type_name: Type without `Action`: `control_msgs/FollowJointTrajectory`.
        on_goal: Is given each new goal, to accept or reject it.
        on_cancel: Is given a goal that somebody wants to be cancelled.
    """

    def __init__(
        self,
        controller: Controller,
        name: str,
        type_name: str,
        *,
        on_goal: Callable[[ServerGoal], None],
        on_cancel: Callable[[ServerGoal], None],
    ) -> None:
        self._controller = controller
        self._type = type_name
        self._on_goal, self._on_cancel = on_goal, on_cancel
        self._goals: dict[str, ServerGoal] = {}
        self._last_cancel_ns = 0
        self._made = 0
        status = message_class("actionlib_msgs/GoalStatusArray")
        self._status = controller.advertise(f"{name}/status", status, latch=True)
        self._feedback = controller.advertise(
            f"{name}/feedback", message_class(f"{type_name}ActionFeedback")
        )
        self._result = controller.advertise(
            f"{name}/result", message_class(f"{type_name}ActionResult")
        )
        goal_class = message_class(f"{type_name}ActionGoal")
        controller.subscribe(f"{name}/goal", goal_class, self._receive_goal, queue_size=50)
        cancel_class = message_class("actionlib_msgs/GoalID")
        controller.subscribe(f"{name}/cancel", cancel_class, self._receive_cancel, queue_size=50)
        controller.create_timer(STATUS_SECONDS, self._publish_status)

    def result(self) -> Any:
        """An empty result."""
        return message_class(f"{self._type}Result")()

    def accept(self, goal: ServerGoal) -> None:
        """Begin with a goal."""
        goal.status = PREEMPTING if goal.status == RECALLING else ACTIVE
        self._publish_status()

    def reject(self, goal: ServerGoal, result: Any, text: str = "") -> None:
        """Refuse a goal."""
        self._end(goal, REJECTED, result, text)

    def succeed(self, goal: ServerGoal, result: Any) -> None:
        """The goal is reached."""
        self._end(goal, SUCCEEDED, result)

    def abort(self, goal: ServerGoal, result: Any) -> None:
        """The goal cannot be reached."""
        self._end(goal, ABORTED, result)

    def cancel(self, goal: ServerGoal, text: str = "") -> None:
        """The goal is given up, by wish of the client or for another goal."""
        ended = PREEMPTED if goal.is_running else RECALLED
        self._end(goal, ended, self.result(), text)

    def feed_back(self, goal: ServerGoal, feedback: Any) -> None:
        """Tell how far a goal is."""
        message: Any = message_class(f"{self._type}ActionFeedback")()
        message.header.stamp = self._now()
        message.status, message.feedback = _status(goal), feedback
        self._feedback.publish(message)

    def _end(self, goal: ServerGoal, status: int, result: Any, text: str = "") -> None:
        goal.status, goal.text, goal.ended_ns = status, text, self._now_ns
        message: Any = message_class(f"{self._type}ActionResult")()
        message.header.stamp = self._now()
        message.status, message.result = _status(goal), result
        self._result.publish(message)
        self._publish_status()

    def _receive_goal(self, message: Any) -> None:
        known = self._goals.get(message.goal_id.id)
        if known is not None:
            if known.status == RECALLING:  # it was cancelled before it came
                self._end(known, RECALLED, self.result())
            return
        goal = ServerGoal(goal_id=self._identified(message.goal_id), goal=message.goal)
        self._goals[goal.goal_id.id] = goal
        if 0 < goal.goal_id.stamp.to_nsec() <= self._last_cancel_ns:
            self.cancel(goal, _EARLY)
        else:
            self._on_goal(goal)

    def _identified(self, goal_id: Any) -> Any:
        """The goal's name and time, made up if they are missing."""
        if not goal_id.id:
            self._made += 1
            seconds = self._now_ns / 1e9
            goal_id.id = f"{self._controller.node.name}-{self._made}-{seconds:.9f}"
        if goal_id.stamp.is_zero():
            goal_id.stamp = self._now()
        return goal_id

    def _receive_cancel(self, message: Any) -> None:
        stamp_ns = message.stamp.to_nsec()
        is_all = not message.id and not stamp_ns
        for goal in tuple(self._goals.values()):
            is_meant = goal.goal_id.id == message.id
            is_early = stamp_ns and goal.goal_id.stamp.to_nsec() <= stamp_ns
            if is_all or is_meant or is_early:
                self._ask_to_cancel(goal)
        if message.id and message.id not in self._goals:
            early = ServerGoal(goal_id=message, goal=None, status=RECALLING)
            early.ended_ns = self._now_ns
            self._goals[message.id] = early
        self._last_cancel_ns = max(self._last_cancel_ns, stamp_ns)

    def _ask_to_cancel(self, goal: ServerGoal) -> None:
        if goal.status not in (PENDING, ACTIVE):
            return
        goal.status = RECALLING if goal.status == PENDING else PREEMPTING
        self._publish_status()
        self._on_cancel(goal)

    def _publish_status(self) -> None:
        oldest_ns = self._now_ns - KEEP_NS
        for name, goal in tuple(self._goals.items()):
            is_over = goal.status in _ENDED or goal.goal is None
            if is_over and goal.ended_ns < oldest_ns:
                del self._goals[name]
        message: Any = message_class("actionlib_msgs/GoalStatusArray")()
        message.header.stamp = self._now()
        message.status_list = [_status(goal) for goal in self._goals.values()]
        self._status.publish(message)

    @property
    def _now_ns(self) -> int:
        return self._controller.node.graph.executor.now_ns

    def _now(self) -> Time:
        return self._controller.node.now()


def _status(goal: ServerGoal) -> Any:
    message: Any = message_class("actionlib_msgs/GoalStatus")()
    message.goal_id, message.status, message.text = goal.goal_id, goal.status, goal.text
    return message
