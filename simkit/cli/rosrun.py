"""`simkit rosrun`: a node, in the simulation of another terminal, or in a new one.

Source: rosrun of ROS Noetic for the command line; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import sys
from typing import TypeAlias

from simkit.cli.pace import run_for_a_person
from simkit.cli.run_options import (
    LAST_WORDS,
    add_run_options,
    take_options,
    wants_own_simulation,
)
from simkit.cli.sharing import OnlyFrom, elsewhere, host, running_session
from simkit.graph.process import ScriptNode
from simkit.graph.screen import StreamScreen
from simkit.live.jobs import keys_of_this_terminal
from simkit.live.moving import offer_moves
from simkit.live.windows import open_windows
from simkit.nodes.builtin import RunningBuiltin
from simkit.simulation import Simulation

_Node: TypeAlias = ScriptNode | RunningBuiltin


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Package, executable, the node's own arguments, and how long and how fast to run."""
    parser.usage = "simkit rosrun [OPTIONS] PACKAGE EXECUTABLE [ARGUMENTS]"
    parser.epilog = (
        "The node joins the simulation of another terminal; if none runs, it begins one, which others then "
        "join. With an option it has a simulation of its own. ARGUMENTS are the node's: _turtle:=turtle2 "
        "sets a private parameter, __name:=x the name, a:=b remaps. OPTIONS may stand behind them too; "
        "what follows -- is the node's, whatever it looks like."
    )
    add_run_options(parser)
    parser.add_argument("package", metavar="PACKAGE", help="e.g. turtlesim")
    parser.add_argument("executable", metavar="EXECUTABLE", help="e.g. turtlesim_node or talker.py")
    parser.add_argument("arguments", metavar="ARGUMENTS", nargs=argparse.REMAINDER)


def run(arguments: argparse.Namespace) -> int:
    """Run the node until it ends, the time is over, or Ctrl-C comes; its exit code."""
    own = take_options(arguments, arguments.arguments, add_run_options, program="simkit rosrun")
    words = [arguments.package, arguments.executable, *own]
    alone = wants_own_simulation(arguments)
    if not alone and running_session() is not None:
        return elsewhere(["rosrun", *words])
    with Simulation(arguments.seed or 0) as sim:
        node = sim.rosrun(*words)
        offer_moves([node])
        open_windows(sim, [node])

        with keys_of_this_terminal([node]) as hand_over:

            def is_over() -> bool:
                hand_over()
                return not node.alive

            if alone:
                end = run_for_a_person(sim, is_over, seconds=arguments.seconds, fast=arguments.fast)
            else:
                sim.graph.screen = OnlyFrom(lambda name: name == node.name, StreamScreen())
                end = "interrupted" if host(sim, is_over) else "over"
        if end == "interrupted":
            node.shutdown()
            sim.run_until(is_over, timeout=LAST_WORDS)
            return 0  # the usual end of a node
        if end == "idle":
            print(f"{node.name} waits for ever: nothing else runs here", file=sys.stderr)
        return _exit_code(node)


def _exit_code(node: _Node) -> int:
    if node.alive or (not node.exit_code and node.failure is None):
        return 0
    return node.exit_code if node.exit_code and node.exit_code > 0 else 1
