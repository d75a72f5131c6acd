"""`simkit rosrun`: a node, in the simulation of another terminal, or in a new one.

Source: rosrun of ROS Noetic for the command line; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import math
import sys
from typing import TypeAlias

from simkit.cli.pace import run_for_a_person
from simkit.cli.parser import CommandParser
from simkit.cli.sharing import OnlyFrom, elsewhere, host, running_session
from simkit.graph.process import ScriptNode
from simkit.graph.screen import StreamScreen
from simkit.running import RunningBuiltin
from simkit.simulation import Simulation

LAST_WORDS = 2.5
"""Virtual time that a node has for its shutdown hooks after Ctrl-C [s]."""
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
    _add_options(parser)
    parser.add_argument("package", metavar="PACKAGE", help="e.g. turtlesim")
    parser.add_argument("executable", metavar="EXECUTABLE", help="e.g. turtlesim_node or talker.py")
    parser.add_argument("arguments", metavar="ARGUMENTS", nargs=argparse.REMAINDER)


def run(arguments: argparse.Namespace) -> int:
    """Run the node until it ends, the time is over, or Ctrl-C comes; its exit code."""
    words = [arguments.package, arguments.executable, *_own_words(arguments)]
    alone = arguments.fast or arguments.seconds is not None or arguments.seed is not None
    if not alone and running_session() is not None:
        return elsewhere(["rosrun", *words])
    with Simulation(arguments.seed or 0) as sim:
        node = sim.rosrun(*words)

        def is_over() -> bool:
            return not node.alive

        if alone:
            end = run_for_a_person(sim, is_over, seconds=arguments.seconds, fast=arguments.fast)
        else:
            sim.graph.screen = OnlyFrom(lambda: node.name, StreamScreen())
            end = "interrupted" if host(sim, is_over) else "over"
        if end == "interrupted":
            node.shutdown()
            sim.run_until(is_over, timeout=LAST_WORDS)
            return 0  # the usual end of a node
        if end == "idle":
            print(f"{node.name} waits for ever: nothing else runs here", file=sys.stderr)
        return _exit_code(node)


def _add_options(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--for",
        dest="seconds",
        metavar="SECONDS",
        type=_seconds,
        help="stop after so much virtual time",
    )
    parser.add_argument(
        "--fast",
        action="store_true",
        help="as fast as the machine can, not at the pace of the wall clock",
    )
    parser.add_argument("--seed", type=int, help="of everything random (0)")


def _own_words(arguments: argparse.Namespace) -> list[str]:
    """The node's arguments; options of ours that stand among them move to `arguments`."""
    words: list[str] = arguments.arguments
    at = words.index("--") if "--" in words else len(words)
    parser = CommandParser(
        prog="simkit rosrun",
        add_help=False,
        allow_abbrev=False,
        argument_default=argparse.SUPPRESS,
    )
    _add_options(parser)
    _, own = parser.parse_known_args(words[:at], arguments)
    return own + words[at + 1 :]


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value >= 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds")
    return value


def _exit_code(node: _Node) -> int:
    if node.alive or (not node.exit_code and node.failure is None):
        return 0
    return node.exit_code if node.exit_code and node.exit_code > 0 else 1
