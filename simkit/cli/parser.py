"""Argument parsers whose complaints are one line."""

from __future__ import annotations

import argparse
import os
import sys
from typing import Any, NoReturn

from simkit.cli.complaint import USAGE_ERROR

_COLUMNS = 80


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


class CommandParser(argparse.ArgumentParser):
    """`argparse`, but an error is one line that says where the help is.

    Args:
        options: As for `argparse.ArgumentParser`.
    """

    def __init__(self, **options: Any) -> None:
        super().__init__(**{"formatter_class": _HelpFormatter, **options})

    def error(self, message: str) -> NoReturn:
        """End the program with a line on standard error and exit code 2."""
        self.exit(USAGE_ERROR, f"{self.prog}: {message}; see {self.prog} --help\n")
