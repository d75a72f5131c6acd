"""Argument parsers that never end the program: what is wrong, and the help, are raised."""

from __future__ import annotations

import argparse
import os
import sys
from typing import Any, NoReturn

from simkit.commands.errors import HelpShown, UsageError

_COLUMNS = 80


class ArgumentParser(argparse.ArgumentParser):
    """An argument parser that complains as the tools of ROS do: with the usage.

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


class LineParser(ArgumentParser):
    """An argument parser that complains in one line, which says where the help is.

    Args:
        prog: Command as it is typed, `simkit rosmsg`.
        options: As for `argparse.ArgumentParser`.
    """

    def __init__(self, prog: str, **options: Any) -> None:
        super().__init__(prog, **{"formatter_class": _HelpFormatter, **options})

    def error(self, message: str) -> NoReturn:
        """Refuse a command line.

        Raises:
            UsageError: Always.
        """
        raise UsageError(f"{self.prog}: {message}; see {self.prog} --help")


class _HelpFormatter(argparse.HelpFormatter):
    """As wide as the terminal, like that of `argparse`, which loads `shutil` and all kinds of compression to ask for it."""

    def __init__(self, prog: str, **options: Any) -> None:
        super().__init__(prog, **{"width": terminal_width() - 2, **options})


def terminal_width() -> int:
    """Columns of the terminal.

    Source:
        `shutil.get_terminal_size`.
    """
    try:
        asked = int(os.environ["COLUMNS"])
    except (KeyError, ValueError):
        asked = 0
    if asked > 0:
        return asked
    stream = sys.__stdout__
    try:
        return (os.get_terminal_size(stream.fileno()).columns if stream else 0) or _COLUMNS
    except (ValueError, OSError):  # no terminal, or none any more
        return _COLUMNS
