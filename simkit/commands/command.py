"""What a command line of ROS is: one function that takes a simulation and words, and yields what is printed as time passes.

Terminals, the lines of a notebook and Python differ in who lets time pass and where texts go, and in nothing else.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, TypeAlias

from simkit.commands.errors import HelpShown, ToolError, UsageError
from simkit.commands.parser import LineParser
from simkit.errors import SimkitError, near_names

if TYPE_CHECKING:
    from simkit.graph import Graph
    from simkit.launch.process import NodeHandle
    from simkit.simulation import Simulation

Write = Callable[[str], None]
"""Takes what a command prints, line breaks included."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wait:
    """What a command yields to let virtual time pass."""

    until: Callable[[], bool] = lambda: False
    "It goes on when this holds,"
    seconds: float = math.inf
    "or when so much virtual time has passed [s]."


@dataclass(frozen=True, slots=True)
class Keys:
    """What a command yields that reads the keyboard of its terminal."""

    press: Callable[[str], None]
    "Takes a key: `up`, `down`, `left`, `right`, or a character."


class ErrorText(str):
    """A text that a command prints on standard error."""

    __slots__ = ()


Answer: TypeAlias = Generator["str | Wait | Keys", None, Any]
"""What a command prints, and what it waits for; it returns its exit code, or None for 0."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Bounds:
    """When a command ends that in a terminal goes on until Ctrl-C; the nodes that it has started go on."""

    seconds: float = 10.0
    "So much virtual time [s]."
    messages: int | None = None
    "So many messages; any number if None."
    start: float = 0.5
    "How long to watch a node that was started, so that its first faults show [s]."


UNBOUNDED = Bounds(seconds=math.inf, start=math.inf)
"""In a terminal: until Ctrl-C, which ends the nodes too."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Call:
    """One call of a command."""

    simulation: Simulation | None = None
    "The simulation it acts on; None for what needs none."
    words: Sequence[str]
    "The words after the command's name."
    bounds: Bounds = UNBOUNDED
    "When it ends if nothing else ends it."
    show_window: Callable[[NodeHandle], object] = lambda node: None  # noqa: ARG005
    "Shows the window of a node that it has started, where it was typed."
    opening: str = ""
    "What `roslaunch` says first: whose simulation this is."
    hosts: bool = False
    "Whether the simulation ends with the command."

    @property
    def sim(self) -> Simulation:
        """The simulation it acts on.

        Raises:
            SimkitError: There is none.
        """
        if self.simulation is None:
            raise SimkitError("no simulation runs")
        return self.simulation

    @property
    def leaves_nodes(self) -> bool:
        """Whether nodes go on that it has started."""
        return math.isfinite(self.bounds.seconds)

    @property
    def graph(self) -> Graph:
        """Graph of the simulation."""
        return self.sim.graph


Command = Callable[[Call], Answer | None]
"""Does what a call asks for; raises `ToolError`."""


def dispatch(
    tool: str, commands: Mapping[str, Command], argv: Sequence[str]
) -> tuple[Command, list[str]]:
    """The command that the first word names, and the words after it.

    Args:
        tool: Name of the tool, `rostopic`.
        commands: Its commands by name.
        argv: Words after the tool's name.

    Raises:
        UsageError: There is no first word, or it names no command; lists them.
    """
    known = ", ".join(commands)
    if not argv:
        raise UsageError(f"{tool} needs a command: {known}", exit_code=64)
    name, *rest = argv
    if name in ("-h", "--help"):
        raise HelpShown(f"Commands: {', '.join(f'{tool} {command}' for command in commands)}")
    if name not in commands:
        near = near_names(name, commands)
        meant = f"; did you mean {near[0]}?" if near else ";"
        raise UsageError(f"{tool} has no command {name!r}{meant} Commands: {known}", exit_code=64)
    return commands[name], rest


def subcommands(tool: str, commands: Mapping[str, Command]) -> Callable[[Call], Answer]:
    """The command whose first word names another one: `rostopic`.

    Args:
        tool: Its name.
        commands: What the first word may be.
    """

    def run(call: Call) -> Answer:
        try:
            command, words = dispatch(tool, commands, call.words)
            answer = command(replace(call, words=words))
            return None if answer is None else (yield from answer)
        except HelpShown as help_text:
            yield f"{help_text}\n"
        except ToolError:
            raise
        except SimkitError as error:
            raise ToolError(f"ERROR: {error}") from error
        return 0

    return run


def parsed(
    name: str,
    add_arguments: Callable[[argparse.ArgumentParser], None],
    answer: Callable[[argparse.Namespace], Answer],
) -> Callable[[Call], Answer]:
    """The command of a program with options, which needs no simulation: `rosmsg`.

    Args:
        name: Its name.
        add_arguments: Tells a parser what it takes.
        answer: Does what was asked for.
    """

    def run(call: Call) -> Answer:
        from simkit.commands.table import COMMANDS  # the table names this module

        parser = LineParser(f"simkit {name}", description=COMMANDS[name].summary)
        parser.set_defaults(command=name)
        add_arguments(parser)
        return (yield from answer(parser.parse_args(call.words)))

    return run


def texts(call: Call, answer: Answer) -> Iterator[str]:
    """What a command prints while this process lets time pass, as fast as it can.

    Args:
        call: What was called.
        answer: What that gave.
    """
    for item in answer:
        if isinstance(item, Wait):
            call.sim.run_until(item.until, min(item.seconds, call.bounds.seconds))
        elif isinstance(item, str):
            yield item


def to_stdout(text: str) -> None:
    """Print a text as it is, where standard output goes at the moment."""
    sys.stdout.write(text)
