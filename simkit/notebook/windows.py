"""What rviz and gzclient show, below the cell that has started it."""

from __future__ import annotations

from collections.abc import Iterable

from IPython.display import display

from simkit.graph.process import ScriptNode
from simkit.nodes.builtin import RunningBuiltin
from simkit.simulation import Simulation


def show_windows(sim: Simulation, nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Display the view of each node that is an rviz or a gzclient.

    Args:
        sim: The simulation.
        nodes: What was just started.
    """
    for node in nodes:
        window = sim.window_of(node)
        if window is not None:
            display(window)  # type: ignore[no-untyped-call]
