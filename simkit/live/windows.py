"""Windows where no window opens: in a terminal, which is given the address of a page, or the line that moves a joint."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.graph.process import ScriptNode
from simkit.nodes.builtin import RunningBuiltin
from simkit.nodes.joint_state_publisher import JointStatePublisherGui
from simkit.simulation import Simulation


def show_windows(sim: Simulation, nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Serve the view of each node that is an rviz, a gzclient or a turtlesim; the node prints where.

    A joint_state_publisher_gui listens to a topic, and says which line moves a joint.

    Args:
        sim: The simulation.
        nodes: What was just started in a terminal.
    """
    for node in nodes:
        program = getattr(node, "program", None)
        if isinstance(program, JointStatePublisherGui):
            program.listen()
        sim.serve_window_of(node)
