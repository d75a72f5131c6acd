"""`rosrun`: a node, until it ends or its terminal ends it.

Source: rosrun of ROS Noetic for the command line; `--for`, `--fast` and `--seed` are ours.
"""

from __future__ import annotations

import argparse
import contextlib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from simkit.commands.command import Answer, Call, Keys, Wait
from simkit.commands.errors import UsageError
from simkit.errors import UnknownNameError
from simkit.graph import LogLevel, LogRecord
from simkit.nodes import builtin_nodes

if TYPE_CHECKING:
    from simkit.launch.process import NodeHandle
    from simkit.packages import PackagePath
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


def add_options(parser: argparse.ArgumentParser) -> None:
    """`--for`, `--fast` and `--seed`."""
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


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value >= 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds")
    return value


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Package, executable, and the node's own arguments."""
    parser.add_argument("package", metavar="PACKAGE", help="e.g. turtlesim")
    parser.add_argument(
        "executable",
        metavar="EXECUTABLE",
        nargs="?",
        help="e.g. turtlesim_node or talker.py; without it, those of the package are listed",
    )
    parser.add_argument("words", metavar="ARGUMENTS", nargs=argparse.REMAINDER)


def own_words(arguments: argparse.Namespace, rest: list[str]) -> list[str]:
    """The words for `rosrun` itself.

    Args:
        arguments: What the parser has found.
        rest: What stands behind the executable, without options of ours.
    """
    executable = [] if arguments.executable is None else [arguments.executable]
    return [arguments.package, *executable, *rest]


def run(call: Call) -> Answer:
    """Start a node, give what it says, and end it with the command.

    Where nodes go on after the command, one that only prints what it sees does not, unless a last `&` asks for it.
    """
    words = list(call.words)
    in_background = call.leaves_nodes and words[-1:] == ["&"]
    if in_background:
        words.pop()
    if not words:
        raise UsageError("Usage: rosrun PACKAGE EXECUTABLE [ARGUMENTS]")
    if len(words) == 1:
        yield "".join(f"{name}\n" for name in executables(call.sim.packages, words[0]))
        return 0
    output = NodeOutput(call.sim, lambda: [(node.name, node)], form=_log_line)
    node = call.sim.rosrun(*words)
    call.show_window(node)
    if takes_keys(node):
        yield Keys(partial(press, node))
    seconds = None if in_background else _watch_seconds(words)
    ends = seconds is not None or not call.leaves_nodes
    try:
        bound = seconds if call.leaves_nodes and seconds is not None else call.bounds.start
        yield from watch_output(call, output, lambda: not node.alive, seconds=bound)
        return exit_code_of_node(node)
    except KeyboardInterrupt:
        node.shutdown()
        yield Wait(until=lambda: not node.alive, seconds=LAST_WORDS)
        yield output.new()
        return 0  # the usual end of a node
    finally:
        if ends:
            node.shutdown()


def executables(packages: PackagePath, package: str) -> list[str]:
    """What `rosrun` can start of a package, sorted.

    Args:
        packages: Where packages are.
        package: Name of the package.

    Raises:
        UnknownNameError: There is no such package.
    """
    builtin = {executable for name, executable in builtin_nodes() if name == package}
    if builtin and package not in packages.packages():
        return sorted(builtin)
    return sorted({*builtin, *packages.find(package).executables()})


def _watch_seconds(words: Sequence[str]) -> float | None:
    """How long to watch a node that only prints what it sees; None for other nodes."""
    definition = builtin_nodes().get((words[0], words[1]))
    return None if definition is None else definition.watch_seconds


def _log_line(record: LogRecord) -> str:
    return f"[{record.level.name}] [{record.time.to_sec():.6f}]: {record.text}\n"


def takes_keys(node: NodeHandle) -> bool:
    """Whether a node reads the keyboard of its terminal: its program has a method `press`."""
    return node.alive and hasattr(getattr(node, "program", None), "press")


def press(node: NodeHandle, key: str) -> None:
    """Hand a key to a node that takes keys; one that the program does not know is ignored, as in ROS."""
    program: Any = getattr(node, "program", None)
    if takes_keys(node):
        with contextlib.suppress(UnknownNameError):
            program.press(key)


def exit_code_of_node(node: NodeHandle) -> int:
    """What `rosrun` ends with: the exit code of the node, 1 if it failed or was killed."""
    if node.alive or (not node.exit_code and node.failure is None):
        return 0
    return node.exit_code if node.exit_code and node.exit_code > 0 else 1


def watch_output(
    call: Call, output: NodeOutput, is_over: Callable[[], bool], *, seconds: float
) -> Answer:
    """Give what nodes print until something is over, or so much virtual time has passed [s]."""
    end = call.sim.now.to_sec() + seconds
    while not is_over() and (left := end - call.sim.now.to_sec()) > 0:
        yield output.new()
        yield Wait(until=lambda: output.has_new or is_over(), seconds=left)
    yield output.new()


@dataclass(slots=True)
class NodeOutput:
    """What nodes have printed and logged since a command began; nothing where the simulation has a screen, which shows it."""

    sim: Simulation
    "The simulation."
    nodes: Callable[[], Sequence[tuple[str, NodeHandle]]]
    "The nodes, each with its name."
    form: Callable[[LogRecord], str]
    "What is shown of a line of rosout."
    hides: Callable[[str], bool] = lambda name: False  # noqa: ARG005
    "Whether what a node of this name prints is not shown, and only its warnings and errors are."
    note_hidden: Callable[[str], None] = lambda name: None  # noqa: ARG005
    "Notes that something was not shown."
    lines: Callable[[], Sequence[str]] = tuple
    "What is said of the nodes beside that."
    _shown: list[int] = field(default_factory=list)
    _records: int = -1
    _lines: int = 0

    def __post_init__(self) -> None:
        self._records = len(self.sim.log)

    @property
    def has_new(self) -> bool:
        """Whether there may be more than was given."""
        sizes = [len(node.output) for _, node in self.nodes()]
        return (
            sizes != self._shown
            or len(self.sim.log) > self._records
            or len(self.lines()) > self._lines
        )

    def new(self) -> str:
        """What has come since the last time."""
        texts = [*self._printed(), *self._logged()]
        lines = self.lines()[self._lines :]
        self._lines += len(lines)
        texts += [f"{line}\n" for line in lines]
        return "".join(texts) if self.sim.graph.screen is None else ""

    def _printed(self) -> list[str]:
        texts, sizes = [], []
        for number, (name, node) in enumerate(self.nodes()):
            text = node.output
            new = text[self._shown[number] :] if number < len(self._shown) else text
            sizes.append(len(text))
            if new and self.hides(name):
                self.note_hidden(name)
            else:
                texts.append(new)
        self._shown = sizes
        return texts

    def _logged(self) -> list[str]:
        names = {name for name, _ in self.nodes()}
        records = self.sim.log[self._records :]
        self._records += len(records)
        texts = []
        for record in records:
            if record.node in names and record.level < LogLevel.WARN and self.hides(record.node):
                self.note_hidden(record.node)
            elif record.node in names:
                texts.append(self.form(record))
        return texts
