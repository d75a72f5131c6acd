"""Reads command lines as the tools of ROS do, but never ends the program."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn

from simkit.errors import near_names
from simkit.tools.errors import ToolError, UsageError
from simkit.tools.world import Bounds, World, Write


@dataclass(frozen=True, slots=True, kw_only=True)
class Call:
    """One call of a command."""

    world: World
    "The simulation it acts on."
    words: Sequence[str]
    "The words after the command's name."
    write: Write
    "Takes what it prints."
    bounds: Bounds
    "When it ends if nothing else ends it."


Command = Callable[[Call], None]
"""Does what a call asks for; raises `ToolError`."""


class HelpShown(ToolError):
    """The words asked for help; the text is the help, and nothing went wrong."""

    def __init__(self, text: str) -> None:
        super().__init__(text, exit_code=0)


class ArgumentParser(argparse.ArgumentParser):
    """An argument parser whose faults are errors, not the end of the program.

    Args:
        name: Command as it is typed, `rostopic echo`.
    """

    def __init__(self, name: str, **settings: Any) -> None:
        super().__init__(prog=name, allow_abbrev=False, **settings)

    def error(self, message: str) -> NoReturn:
        """Refuse a command line.

        Raises:
            UsageError: Always; the text is the usage and the fault.
        """
        raise UsageError(f"{self.format_usage().rstrip()}\n\n{self.prog}: error: {message}")

    def print_help(self, file: object = None) -> NoReturn:  # noqa: ARG002 - argparse's argument
        """Show the help.

        Raises:
            HelpShown: Always; the text is the help.
        """
        raise HelpShown(self.format_help().rstrip())


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
