"""Which simulations of this process are open, and the processes that dropped ones have left."""

from __future__ import annotations

import weakref
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from simkit.graph.process import ScriptNode
    from simkit.simulation.simulation import Simulation

_made: list[weakref.ref[Simulation]] = []
_abandoned: list[list[ScriptNode]] = []


def note_open(sim: Simulation, scripts: list[ScriptNode]) -> None:
    """Note a new simulation, and end the processes of those that were dropped.

    A notebook's `sim = Simulation()` drops the one before it: its processes end when the next one begins, and not in the
    middle of whatever runs when the garbage is collected.

    Args:
        sim: The new one.
        scripts: Where it will keep the scripts that it has started.
    """
    while _abandoned:
        for script in _abandoned.pop():
            script.close()
    weakref.finalize(sim, _abandoned.append, scripts)
    _made.append(weakref.ref(sim, _made.remove))


def newest_simulation() -> Simulation | None:
    """The open simulation of this process that was made last: what a line of a notebook acts on."""
    for made in reversed(_made):
        sim = made()
        if sim is not None and not sim.closed:
            return sim
    return None
