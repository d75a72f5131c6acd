"""The sliders of a joint_state_publisher_gui below the cell that has started it."""

from __future__ import annotations

from collections.abc import Iterable

from IPython.display import display

from simkit.graph.process import ScriptNode
from simkit.nodes.builtin import RunningBuiltin
from simkit.nodes.joint_state_publisher import JointStatePublisherGui
from simkit.simulation import Simulation


def show_sliders(sim: Simulation, nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Display sliders for each node that opens a window with sliders in ROS; a text without a notebook.

    Args:
        sim: The simulation.
        nodes: What was just started.
    """
    for node in nodes:
        program = getattr(node, "program", None)
        if isinstance(program, JointStatePublisherGui) and node.alive:
            display(sim.joint_sliders(node.name))  # type: ignore[no-untyped-call]
