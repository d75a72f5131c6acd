"""Nodes that come with the kit: objects in this process with callbacks and timers.

They are found by package and executable, as `rosrun` names them.
"""

from simkit.nodes.registry import BuiltinNode, builtin_nodes

__all__ = ["BuiltinNode", "builtin_nodes"]
