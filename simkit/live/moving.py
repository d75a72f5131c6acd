"""How joints are moved where no window opens: in a terminal."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.graph.process import ScriptNode
from simkit.nodes.builtin import RunningBuiltin
from simkit.nodes.joint_state_publisher import JointStatePublisherGui


def offer_moves(nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Let each joint_state_publisher_gui listen to a topic, and say which line moves a joint.

    Args:
        nodes: What was just started in a terminal.
    """
    for node in nodes:
        program = getattr(node, "program", None)
        if isinstance(program, JointStatePublisherGui):
            program.listen()
