"""`simkit rostopic`, `rosnode`, `rosservice`, `rosparam`: the tools of ROS, on the simulation of another terminal."""

from __future__ import annotations

import argparse

from simkit.cli.sharing import elsewhere


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The words of the tool, whatever they look like."""
    parser.usage = f"{parser.prog} COMMAND [ARGUMENTS]"
    parser.add_argument("words", metavar="COMMAND", nargs=argparse.REMAINDER)


def run(arguments: argparse.Namespace) -> int:
    """Do it; the tool's own exit code."""
    return elsewhere([arguments.command, *arguments.words])
