"""One turtle's topics and services, in the namespace of its name.

Source: turtlesim `Turtle`, constructor and callbacks.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Node
from simkit.msgs import Message, message_class, service_class
from simkit.nodes.turtlesim.pen import new_pen
from simkit.nodes.turtlesim.state import Reading, Velocity
from simkit.nodes.turtlesim.turtle import Turtle


class TurtleEndpoints:
    """Connects a turtle to the graph until closed.

    Args:
        node: The node that offers the topics and services.
        turtle: The turtle behind them.
    """

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self._node = node
        self._turtle = turtle
        self._pose_class: Any = message_class("turtlesim/Pose")
        self._color_class: Any = message_class("turtlesim/Color")
        self._set_pen_class = service_class("turtlesim/SetPen")
        self._absolute_class = service_class("turtlesim/TeleportAbsolute")
        self._relative_class = service_class("turtlesim/TeleportRelative")
        name = turtle.name
        self._commands = node.subscribe(
            f"{name}/cmd_vel", message_class("geometry_msgs/Twist"), self._on_command, queue_size=1
        )
        self._poses = node.advertise(f"{name}/pose", self._pose_class, queue_size=1)
        self._colors = node.advertise(f"{name}/color_sensor", self._color_class, queue_size=1)
        self._servers = (
            node.advertise_service(f"{name}/set_pen", self._set_pen_class, self._set_pen),
            node.advertise_service(
                f"{name}/teleport_relative", self._relative_class, self._relative
            ),
            node.advertise_service(
                f"{name}/teleport_absolute", self._absolute_class, self._absolute
            ),
        )

    def publish(self, reading: Reading) -> None:
        """Tell the graph what an update of the turtle gave."""
        if reading.clamped_from is not None:
            x, y = reading.clamped_from
            self._node.warn(f"Oh no! I hit the wall! (Clamping from [x={x:f}, y={y:f}])")
        pose = reading.pose
        self._poses.publish(
            self._pose_class(
                x=pose.x,
                y=pose.y,
                theta=pose.theta,
                linear_velocity=pose.linear_velocity,
                angular_velocity=pose.angular_velocity,
            )
        )
        red, green, blue = reading.color
        self._colors.publish(self._color_class(r=red, g=green, b=blue))

    def close(self) -> None:
        """Withdraw the turtle's topics and services."""
        self._commands.unregister()
        self._poses.unregister()
        self._colors.unregister()
        for server in self._servers:
            server.shutdown()

    def _on_command(self, twist: Any) -> None:
        self._turtle.command(Velocity(x=twist.linear.x, y=twist.linear.y, angular=twist.angular.z))

    def _set_pen(self, request: Any) -> Message:
        if request.off:
            self._turtle.pen = self._turtle.pen.lifted()
        else:
            self._turtle.pen = new_pen((request.r, request.g, request.b), request.width)
        return _response(self._set_pen_class)

    def _relative(self, request: Any) -> Message:
        self._turtle.teleport_relative(request.linear, request.angular)
        return _response(self._relative_class)

    def _absolute(self, request: Any) -> Message:
        self._turtle.teleport_absolute(request.x, request.y, theta=request.theta)
        return _response(self._absolute_class)


def _response(service: Any) -> Message:
    response: Message = service._response_class()
    return response
