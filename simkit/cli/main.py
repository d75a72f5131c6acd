"""Finds the command, runs it, and says in one line what went wrong."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from simkit.cli.complaint import FAILURE, INTERRUPTED, USAGE_ERROR, complain
from simkit.cli.parser import CommandParser
from simkit.cli.registry import Command, commands
from simkit.errors import SimkitError, near_names


def main(arguments: Sequence[str] | None = None) -> int:
    """Run a command line.

    Args:
        arguments: Words behind `simkit`; those of this process if None.

    Returns:
        The exit code: 0, 1 for a failure, 2 for a command line that cannot be understood.
    """
    words = list(sys.argv[1:] if arguments is None else arguments)
    if not words or words[0] in ("-h", "--help", "help"):
        print(help_text())
        return 0
    if words[0] == "--version":
        from simkit import __version__

        print(f"simkit {__version__}")
        return 0
    known = commands()
    if words[0] not in known:
        return complain("simkit", _unknown(words[0], list(known)), USAGE_ERROR)
    return _run(known[words[0]], words[1:])


def help_text() -> str:
    """What `simkit --help` prints: the commands in groups."""
    lines = ["usage: simkit COMMAND ...", "", "ROS 1 for learning, without ROS."]
    group = ""
    for command in commands().values():
        if command.group != group:
            group = command.group
            lines += ["", f"{group}:"]
        lines.append(f"  {command.name:<18} {command.summary}")
    lines += ["", "simkit COMMAND --help says more; simkit --version says which simkit this is."]
    return "\n".join(lines)


def _run(command: Command, words: Sequence[str]) -> int:
    program = f"simkit {command.name}"
    parser = CommandParser(prog=program, description=command.summary, allow_abbrev=False)
    try:
        command.fill(parser)
        code = int(command.load().run(parser.parse_args(words)))
        sys.stdout.flush()
    except SystemExit as end:  # argparse has said its word
        return end.code if isinstance(end.code, int) else FAILURE
    except BrokenPipeError:
        # Whoever read along (`| head`) has enough; Python must not complain of it at its end either.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILURE
    except (SimkitError, OSError) as error:
        return complain(program, str(error))
    except KeyboardInterrupt:
        return INTERRUPTED
    return code


def _unknown(word: str, known: list[str]) -> str:
    near = near_names(word, known)
    meant = f"; did you mean {' or '.join(near)}?" if near else ";"
    return f"no command {word!r}{meant} Commands: {', '.join(known)}"
