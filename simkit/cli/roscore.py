"""`simkit roscore`: a simulation with nothing in it, for other terminals to join."""

from __future__ import annotations

import argparse

from simkit.cli.sharing import host, running_session, show
from simkit.errors import SimkitError
from simkit.simulation import Simulation


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none but the seed."""
    parser.add_argument("--seed", type=int, default=0, help="of everything random (0)")


def run(arguments: argparse.Namespace) -> int:
    """Host a simulation until Ctrl-C."""
    if running_session() is not None:
        raise SimkitError("it cannot run here: a simulation is running already in another terminal")
    with Simulation(arguments.seed, screen=None) as sim:
        show("a simulation runs; other terminals join it with simkit rosrun ...; Ctrl-C ends it\n")
        host(sim, lambda: False)
    return 0
