"""Windows where no window opens: a terminal is told the address of a page."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.graph.process import ScriptNode
from simkit.nodes.builtin import RunningBuiltin
from simkit.simulation import Simulation


def open_windows(sim: Simulation, nodes: Iterable[ScriptNode | RunningBuiltin]) -> None:
    """Serve the view of each node that is an rviz, a gzclient or a turtlesim; the node prints where.

    Args:
        sim: The simulation.
        nodes: What was just started in a terminal.
    """
    for node in nodes:
        sim.serve_window_of(node)
