"""`roscore`: a simulation with nothing in it, for other terminals to join."""

from __future__ import annotations

import argparse

from simkit.commands.command import Answer, Call, Wait

USAGE = "simkit roscore [--seed SEED]"
"""Its command line in a terminal."""
EPILOG = ""
"""What its help says below the options."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """The seed."""
    parser.add_argument("--seed", type=int, help="of everything random (0)")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none of its own."""
    parser.set_defaults(words=[])


def own_words(_arguments: argparse.Namespace, rest: list[str]) -> list[str]:
    """The words for `roscore` itself: none."""
    return rest


def run(_call: Call) -> Answer:
    """Stay until Ctrl-C."""
    yield "a simulation runs; other terminals join it with simkit rosrun ...; Ctrl-C ends it\n"
    try:
        yield Wait()
    except KeyboardInterrupt:
        return 0
