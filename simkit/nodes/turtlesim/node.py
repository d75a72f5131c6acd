"""turtlesim_node: the window of turtles as a node, with its services, parameters and timer.

Each turtle has topics and services in the namespace of its name.

Source: turtlesim `TurtleFrame` and `Turtle`: texts of the log, order of events, and what each service does.
"""

from __future__ import annotations

import math
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Node, ServiceFailed
from simkit.msgs import Duration, Message, message_class, service_class
from simkit.nodes.program import Program
from simkit.nodes.turtlesim.frame import Frame, TurtleExistsError
from simkit.nodes.turtlesim.state import TurtleReading, Velocity, new_pen
from simkit.nodes.turtlesim.turtle import Turtle
from simkit.nodes.turtlesim.window import BACKGROUND, CENTRE, TICK_NS, Rgb

PARAMETERS = ("~background_r", "~background_g", "~background_b")


class TurtlesimNode(Program):
    """The node `turtlesim_node` of the package turtlesim.

    Services: `spawn`, `kill`, `clear`, `reset`; `frame` holds the turtles and their trails.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none.
    """

    window = "turtlesim"

    def __init__(self, node: Node, _argv: list[str]) -> None:
        super().__init__(node)
        self._endpoints: dict[str, _TurtleEndpoints] = {}
        self._is_ticking = False
        for name, default in zip(PARAMETERS, BACKGROUND, strict=True):
            if not node.has_param(name):
                node.set_param(name, default)
        self.frame = Frame(self._background())
        self._empty: Any = service_class("std_srvs/Empty")._response_class
        self._spawned: Any = service_class("turtlesim/Spawn")._response_class
        self._killed: Any = service_class("turtlesim/Kill")._response_class
        node.advertise_service("clear", service_class("std_srvs/Empty"), self._clear)
        node.advertise_service("reset", service_class("std_srvs/Empty"), self._reset)
        node.advertise_service("spawn", service_class("turtlesim/Spawn"), self._spawn)
        node.advertise_service("kill", service_class("turtlesim/Kill"), self._kill)
        node.info(f"Starting turtlesim with node name {node.name}")
        self._welcome(self.frame.spawn(), x=CENTRE, y=CENTRE, theta=0.0)
        node.create_timer(Duration.from_nsec(TICK_NS), self._tick)

    def _tick(self) -> None:
        # turtlesim's first update only notes the time.
        if not self._is_ticking:
            self._is_ticking = True
            return
        for turtle, reading in self.frame.update(self._node.now().to_nsec()):
            self._endpoints[turtle.name].publish(reading)

    def _spawn(self, request: Any) -> Message:
        # A failed call says nothing to its caller, as in turtlesim; the reason is in the log.
        try:
            self._node.resolve(request.name)
            turtle = self.frame.spawn(request.name, x=request.x, y=request.y, theta=request.theta)
        except TurtleExistsError as error:
            self._node.error(f"A turtled named [{request.name}] already exists")
            raise ServiceFailed("") from error
        except SimkitError as error:
            self._node.error(f"Exception thrown while processing service call: {error}")
            raise ServiceFailed(str(error)) from error
        self._welcome(turtle, x=request.x, y=request.y, theta=request.theta)
        response: Message = self._spawned(name=turtle.name)
        return response

    def _kill(self, request: Any) -> Message:
        try:
            self.frame.kill(request.name)
        except UnknownNameError as error:
            self._node.error(f"Tried to kill turtle [{request.name}], which does not exist")
            raise ServiceFailed("") from error
        self._endpoints.pop(request.name).close()
        response: Message = self._killed()
        return response

    def _clear(self, _request: Any) -> Message:
        self._node.info("Clearing turtlesim.")
        self.frame.paper.clear(self._background())
        response: Message = self._empty()
        return response

    def _reset(self, _request: Any) -> Message:
        self._node.info("Resetting turtlesim.")
        for endpoints in self._endpoints.values():
            endpoints.close()
        self._endpoints.clear()
        turtle = self.frame.reset(self._background())
        self._welcome(turtle, x=CENTRE, y=CENTRE, theta=0.0)
        response: Message = self._empty()
        return response

    def _welcome(self, turtle: Turtle, *, x: float, y: float, theta: float) -> None:
        self._endpoints[turtle.name] = _TurtleEndpoints(self._node, turtle)
        self._node.info(
            f"Spawning turtle [{turtle.name}] at x=[{x:f}], y=[{y:f}], theta=[{theta:f}]"
        )

    def _background(self) -> Rgb:
        red, green, blue = (
            _color_part(self._node.get_param(name, default), default)
            for name, default in zip(PARAMETERS, BACKGROUND, strict=True)
        )
        return (red, green, blue)


def _color_part(value: object, default: int) -> int:
    """What roscpp and Qt make of a parameter: rounded, its lowest eight bits.

    Anything but a number counts as the default.
    """
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return default
    return math.floor(value + 0.5) & 0xFF


class _TurtleEndpoints:
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

    def publish(self, reading: TurtleReading) -> None:
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
