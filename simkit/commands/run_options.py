"""What `simkit rosrun` and `simkit roslaunch` have in common: how long and how fast to run, and whose words are whose."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable

from simkit.commands.parser import LineParser


def add_run_options(parser: argparse.ArgumentParser) -> None:
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


def wants_own_simulation(arguments: argparse.Namespace) -> bool:
    """Whether an option asks for a simulation that nobody else joins."""
    return bool(arguments.fast or arguments.seconds is not None or arguments.seed is not None)


def take_options(
    arguments: argparse.Namespace,
    words: list[str],
    add_options: Callable[[argparse.ArgumentParser], None],
    *,
    program: str,
) -> list[str]:
    """The words that are not options of ours; the options among them move to `arguments`.

    Args:
        arguments: Takes the options.
        words: What stands behind the first word that is no option; all behind `--` stays as it is.
        add_options: Tells a parser the options.
        program: Who complains, e.g. `simkit rosrun`.
    """
    at = words.index("--") if "--" in words else len(words)
    parser = LineParser(program, add_help=False, argument_default=argparse.SUPPRESS)
    add_options(parser)
    _, own = parser.parse_known_args(words[:at], arguments)
    return own + words[at + 1 :]


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value >= 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of seconds")
    return value
