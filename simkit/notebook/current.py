"""Which simulation a line of a notebook acts on."""

from __future__ import annotations

from simkit.simulation import Simulation, newest_simulation

_of_lines: list[Simulation] = []
"""The one that a line made: a notebook that has only lines has nobody else to hold it."""


def current_simulation() -> Simulation:
    """The newest open simulation of this process; a new one if there is none."""
    newest = newest_simulation()
    if newest is not None:
        return newest
    made = Simulation()
    _of_lines[:] = [made]
    return made
