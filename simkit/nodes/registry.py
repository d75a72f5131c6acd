"""Which built-in nodes there are; the code of one is imported when it is started."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from simkit.graph import Node


@dataclass(frozen=True, slots=True, kw_only=True)
class BuiltinNode:
    """A node of the kit, and its factory: called with a graph node and arguments, it starts."""

    package: str
    """ROS package, e.g. `turtlesim`."""
    executable: str
    """What `rosrun` is given after the package, e.g. `turtlesim_node`."""
    node_name: str
    """Name that the node gives itself when nobody gives it another."""
    module: str
    """Python module of its class."""
    class_name: str
    """Its class, made with (node, argv)."""

    def __call__(self, node: Node, argv: list[str]) -> object:
        """Start the node.

        Args:
            node: Its place in the graph.
            argv: Arguments of its command line, without remappings.
        """
        return getattr(importlib.import_module(self.module), self.class_name)(node, argv)


_BUILTIN = (
    BuiltinNode(
        package="turtlesim",
        executable="turtlesim_node",
        node_name="turtlesim",
        module="simkit.nodes.turtlesim.node",
        class_name="TurtlesimNode",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="turtle_teleop_key",
        node_name="teleop_turtle",
        module="simkit.nodes.turtlesim.teleop",
        class_name="TurtleTeleop",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="draw_square",
        node_name="draw_square",
        module="simkit.nodes.turtlesim.draw_square",
        class_name="DrawSquare",
    ),
    BuiltinNode(
        package="turtlesim",
        executable="mimic",
        node_name="turtle_mimic",
        module="simkit.nodes.turtlesim.mimic",
        class_name="Mimic",
    ),
)


def builtin_nodes() -> dict[tuple[str, str], BuiltinNode]:
    """All built-in nodes by (package, executable)."""
    return {(builtin.package, builtin.executable): builtin for builtin in _BUILTIN}
