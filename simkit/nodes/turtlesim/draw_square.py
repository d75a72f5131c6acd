"""draw_square: drives turtle1 along squares of 2 m, steered by its pose alone.

Source: turtlesim tutorial `draw_square`: speeds, tolerances, period, texts.
"""

from __future__ import annotations

import contextlib
import enum
import math
from dataclasses import dataclass
from typing import Any

from simkit.errors import UnknownNameError
from simkit.graph import Node
from simkit.msgs import Duration, message_class, service_class
from simkit.nodes.turtlesim.window import float32

PERIOD_NS = 16_000_000
SIDE = 2.0  # [m]
FORWARD_SPEED = 1.0  # [m/s]
TURN_SPEED = 0.4  # [rad/s]
NEAR = 0.1  # [m], in x and in y
ALIGNED = 0.01  # [rad]
STILL = 0.0001  # [m/s] and [rad/s]
PI = 3.141592  # the tutorial's own


class _Phase(enum.Enum):
    FORWARD = enum.auto()
    STOP_FORWARD = enum.auto()
    TURN = enum.auto()
    STOP_TURN = enum.auto()


@dataclass(frozen=True, slots=True, kw_only=True)
class _Goal:
    x: float
    y: float
    theta: float


class DrawSquare:
    """The node `draw_square` of the package turtlesim; it resets turtlesim when it starts.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        self._node = node
        self._pose: Any = None
        self._goal: _Goal | None = None
        self._phase = _Phase.FORWARD
        self._twist_class: Any = message_class("geometry_msgs/Twist")
        node.subscribe("turtle1/pose", message_class("turtlesim/Pose"), self._on_pose, queue_size=1)
        self._publisher = node.advertise("turtle1/cmd_vel", self._twist_class, queue_size=1)
        node.create_timer(Duration.from_nsec(PERIOD_NS), self._tick)
        self._reset_turtlesim()

    def _reset_turtlesim(self) -> None:
        request: Any = service_class("std_srvs/Empty")._request_class()
        # Without a turtlesim the tutorial goes on as well: it waits for the first pose.
        with contextlib.suppress(UnknownNameError):
            self._node.graph.call_service(
                self._node.resolve("reset"), request.to_bytes(), self._node.name, lambda *_: None
            )

    def _on_pose(self, pose: Any) -> None:
        self._pose = pose

    def _tick(self) -> None:
        if self._pose is None:
            return
        if self._goal is None:
            self._aim_ahead()
        match self._phase:
            case _Phase.FORWARD:
                self._drive(FORWARD_SPEED, 0.0, then=_Phase.STOP_FORWARD)
            case _Phase.STOP_FORWARD:
                self._stop(then=_Phase.TURN)
            case _Phase.TURN:
                self._drive(0.0, TURN_SPEED, then=_Phase.STOP_TURN)
            case _Phase.STOP_TURN:
                self._stop(then=_Phase.FORWARD)

    def _drive(self, linear: float, angular: float, *, then: _Phase) -> None:
        if self._has_reached_goal():
            self._phase = then
            linear = angular = 0.0
        self._command(linear, angular)

    def _stop(self, *, then: _Phase) -> None:
        if not self._has_stopped():
            self._command(0.0, 0.0)
            return
        self._node.info("Reached goal")
        self._phase = then
        if then is _Phase.FORWARD:
            self._aim_ahead()
        else:
            self._aim_left()

    def _aim_ahead(self) -> None:
        theta = self._pose.theta
        x = self._pose.x + SIDE * math.cos(theta)
        self._aim(x, self._pose.y + SIDE * math.sin(theta), theta=theta)

    def _aim_left(self) -> None:
        theta = math.fmod(self._pose.theta + PI / 2, 2 * PI)
        self._aim(self._pose.x, self._pose.y, theta=theta - 2 * PI if theta >= PI else theta)

    def _aim(self, x: float, y: float, *, theta: float) -> None:
        self._goal = goal = _Goal(x=float32(x), y=float32(y), theta=float32(theta))
        self._node.info(f"New goal [{goal.x:f} {goal.y:f}, {goal.theta:f}]")

    def _has_reached_goal(self) -> bool:
        pose, goal = self._pose, self._goal
        return goal is not None and (
            abs(pose.x - goal.x) < NEAR
            and abs(pose.y - goal.y) < NEAR
            and abs(pose.theta - goal.theta) < ALIGNED
        )

    def _has_stopped(self) -> bool:
        return bool(self._pose.angular_velocity < STILL and self._pose.linear_velocity < STILL)

    def _command(self, linear: float, angular: float) -> None:
        twist = self._twist_class()
        twist.linear.x = linear
        twist.angular.z = angular
        self._publisher.publish(twist)
