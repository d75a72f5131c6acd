"""What built-in programs that print have in common: a place in the graph, an output, an end."""

from __future__ import annotations

import re
from pathlib import Path
from typing import ClassVar

from simkit.graph import Node

_NUMBER = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


class Program:
    """A program that runs as a node in this process and prints.

    What it prints is kept in `output`, and shown on the screen of its graph as it comes.

    Args:
        node: Its place in the graph.

    Attributes:
        exit_code: What it ended with; None while it runs.
    """

    window: ClassVar[str] = ""
    """What has a window in ROS, and a page in a browser here; empty for a program without one."""

    def __init__(self, node: Node) -> None:
        self._node = node
        self._folder = Path.cwd()  # of whoever starts it: files that it names are there
        self._output = ""
        self.exit_code: int | None = None

    @property
    def output(self) -> str:
        """What it has printed so far."""
        return self._output

    def show_address(self, url: str) -> None:
        """Print where its page is, for a person at a terminal."""
        self._print(f"{self.window} is at {url} (open it in a browser; Ctrl-C ends it)\n")

    def _print(self, text: str) -> None:
        """Print a text as it is, without a line break of its own."""
        self._output += text
        self._node.graph.show_output(self._node.name, text)

    def _exit(self, code: int) -> None:
        """End the program and leave the graph."""
        self.exit_code = code
        self._node.shutdown()


def leading_number(text: str) -> float:
    """The number that a text begins with; 0 if it begins with none.

    Source:
        `atof` of C, with which the programs of tf read their arguments.
    """
    found = _NUMBER.match(text)
    return float(found[0]) if found else 0.0


def is_number(text: str) -> bool:
    """Whether the whole text is one number."""
    return _NUMBER.fullmatch(text) is not None
