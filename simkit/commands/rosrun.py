"""`rosrun`: a node, until it ends or its terminal ends it.

Source: rosrun of ROS Noetic for the command line; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import contextlib
from functools import partial
from typing import TYPE_CHECKING, Any

from simkit.commands.command import Answer, Call, Keys, Wait
from simkit.commands.errors import UsageError
from simkit.commands.run_options import add_run_options
from simkit.errors import UnknownNameError

if TYPE_CHECKING:
    from simkit.graph.process import ScriptNode
    from simkit.nodes.builtin import RunningBuiltin
    from simkit.simulation import Simulation

LAST_WORDS = 2.5
"""Virtual time that nodes have for their shutdown hooks after Ctrl-C [s]."""
USAGE = "simkit rosrun [OPTIONS] PACKAGE EXECUTABLE [ARGUMENTS]"
"""Its command line in a terminal."""
EPILOG = (
    "The node joins the simulation of another terminal; if none runs, it begins one, which others then "
    "join. With an option it has a simulation of its own. ARGUMENTS are the node's: _turtle:=turtle2 "
    "sets a private parameter, __name:=x the name, a:=b remaps. OPTIONS may stand behind them too; "
    "what follows -- is the node's, whatever it looks like."
)
"""What its help says below the options."""


add_options = add_run_options


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Package, executable, and the node's own arguments."""
    parser.add_argument("package", metavar="PACKAGE", help="e.g. turtlesim")
    parser.add_argument("executable", metavar="EXECUTABLE", help="e.g. turtlesim_node or talker.py")
    parser.add_argument("words", metavar="ARGUMENTS", nargs=argparse.REMAINDER)


def own_words(arguments: argparse.Namespace, rest: list[str]) -> list[str]:
    """The words for `rosrun` itself.

    Args:
        arguments: What the parser has found.
        rest: What stands behind the executable, without options of ours.
    """
    return [arguments.package, arguments.executable, *rest]


def run(call: Call) -> Answer:
    """Start a node, give what it says, and end it with the command."""
    if len(call.words) < 2:
        raise UsageError("Usage: rosrun PACKAGE EXECUTABLE [ARGUMENTS]")
    begin = len(call.sim.log)
    node = call.sim.rosrun(*call.words)
    said = _Said(call.sim, node, begin)
    call.show_windows([node])
    if takes_keys(node):
        yield Keys(partial(press, node))
    try:
        while True:
            yield said.news()
            if not node.alive:
                return exit_code_of(node)
            yield Wait(until=lambda: said.has_news or not node.alive)
    except KeyboardInterrupt:
        node.shutdown()
        yield Wait(until=lambda: not node.alive, seconds=LAST_WORDS)
        yield said.news()
        return 0  # the usual end of a node
    finally:
        node.shutdown()


def takes_keys(node: ScriptNode | RunningBuiltin) -> bool:
    """Whether a node reads the keyboard of its terminal: its program has a method `press`."""
    return node.alive and hasattr(getattr(node, "program", None), "press")


def press(node: ScriptNode | RunningBuiltin, key: str) -> None:
    """Hand a key to a node that takes keys; one that the program does not know is ignored, as in ROS."""
    program: Any = getattr(node, "program", None)
    if takes_keys(node):
        with contextlib.suppress(UnknownNameError):
            program.press(key)


def exit_code_of(node: ScriptNode | RunningBuiltin) -> int:
    """What `rosrun` ends with: the exit code of the node, 1 if it failed or was killed."""
    if node.alive or (not node.exit_code and node.failure is None):
        return 0
    return node.exit_code if node.exit_code and node.exit_code > 0 else 1


class _Said:
    """What a node has printed and logged, as it comes."""

    def __init__(self, sim: Simulation, node: ScriptNode | RunningBuiltin, begin: int) -> None:
        self._sim = sim
        self._node = node
        self._records = begin
        self._shown = 0

    @property
    def has_news(self) -> bool:
        """Whether there may be more than was given."""
        return len(self._node.output) > self._shown or len(self._sim.log) > self._records

    def news(self) -> str:
        """What has come since the last time."""
        output, records = self._node.output, self._sim.log
        text, self._shown = output[self._shown :], len(output)
        for record in records[self._records :]:
            if record.node == self._node.name:
                text += f"[{record.level.name}] [{record.time.to_sec():.6f}]: {record.text}\n"
        self._records = len(records)
        return text
