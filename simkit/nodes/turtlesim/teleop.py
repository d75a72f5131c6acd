"""turtle_teleop_key: arrow keys become velocity commands, one for each press.

A press moves the turtle for the second that a command lives.

Source: turtlesim `teleop_turtle_key`: keys, scales, printed lines.
"""

from __future__ import annotations

from typing import Any

from simkit.errors import UnknownNameError
from simkit.graph import Node
from simkit.msgs import message_class
from simkit.nodes.program import Program

GREETING = """\
Reading from keyboard
---------------------------
Use arrow keys to move the turtle. 'q' to quit.
"""
"""What the program prints when it starts."""

ARROWS = {"up": (1.0, 0.0), "down": (-1.0, 0.0), "left": (0.0, 1.0), "right": (0.0, -1.0)}
"""Share of the linear and of the angular scale for each arrow key."""


class TurtleTeleop(Program):
    """The node `turtle_teleop_key` of the package turtlesim; `press` is its keyboard.

    Args:
        node: Its place in the graph.
        _argv: Arguments of its command line; it takes none.
    """

    def __init__(self, node: Node, _argv: list[str]) -> None:
        super().__init__(node)
        self._linear_scale = float(node.get_param("scale_linear", 2.0))
        self._angular_scale = float(node.get_param("scale_angular", 2.0))
        self._twist_class: Any = message_class("geometry_msgs/Twist")
        self._publisher = node.advertise("turtle1/cmd_vel", self._twist_class, queue_size=1)
        self._print(GREETING)

    def press(self, key: str) -> None:
        """Press a key.

        Args:
            key: "up", "down", "left", "right", or "q" to quit.

        Raises:
            UnknownNameError: There is no such key.
        """
        if key == "q":
            self._exit(0)
            return
        if key not in ARROWS:
            raise UnknownNameError("key", key, [*ARROWS, "q"])
        linear, angular = ARROWS[key]
        twist = self._twist_class()
        twist.linear.x = linear * self._linear_scale
        twist.angular.z = angular * self._angular_scale
        self._publisher.publish(twist)
