"""Argument parsers whose complaints are one line."""

from __future__ import annotations

import argparse
from typing import NoReturn

from simkit.cli.complaint import USAGE_ERROR


class CommandParser(argparse.ArgumentParser):
    """`argparse`, but an error is one line that says where the help is."""

    def error(self, message: str) -> NoReturn:
        """End the program with a line on standard error and exit code 2."""
        self.exit(USAGE_ERROR, f"{self.prog}: {message}; see {self.prog} --help\n")
