"""Finds the command, runs it, and says in one line what went wrong."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Sequence

from simkit.commands.command import Answer, Call, ErrorText
from simkit.commands.errors import (
    FAILURE,
    INTERRUPTED,
    USAGE_ERROR,
    HelpShown,
    ToolError,
    UsageError,
)
from simkit.commands.table import COMMANDS, Entry, TerminalPlace
from simkit.errors import SimkitError, near_names

_OWN_SIMULATION = ("--fast", "--for", "--seed")
"""Options after which a simulation is begun that nobody joins."""


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
    if words[0] not in COMMANDS:
        from simkit.commands.words import ABSENT, SHORTHANDS

        if words[0] in SHORTHANDS:
            return main(SHORTHANDS[words[0]](words[1:]))
        if words[0] in ABSENT:
            return complain("simkit", f"there is no {words[0]} here: {ABSENT[words[0]]}")
        return complain("simkit", _unknown(words[0], list(COMMANDS)), USAGE_ERROR)
    return _run(COMMANDS[words[0]], words[1:])


def help_text() -> str:
    """What `simkit --help` prints: the commands in groups."""
    lines = ["usage: simkit COMMAND ...", "", "ROS 1 for learning, without ROS."]
    group = ""
    for command in COMMANDS.values():
        if command.group != group:
            group = command.group
            lines += ["", f"{group}:"]
        lines.append(f"  {command.name:<18} {command.summary}")
    lines += ["", "simkit COMMAND --help says more; simkit --version says which simkit this is."]
    return "\n".join(lines)


def _run(entry: Entry, words: Sequence[str]) -> int:
    program = f"simkit {entry.name}"
    try:
        code = _do(entry, words)
        sys.stdout.flush()
    except BrokenPipeError:
        # Whoever read along (`| head`) has enough; Python must not complain of it at its end either.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILURE
    except HelpShown as text:
        print(text)
        return 0
    except UsageError as error:  # it says itself which command it is
        print(error, file=sys.stderr)
        return error.exit_code
    except ToolError as error:
        return complain(program, str(error), error.exit_code)
    except (SimkitError, OSError) as error:
        return complain(program, str(error))
    except KeyboardInterrupt:
        return INTERRUPTED
    return code


def _do(entry: Entry, words: Sequence[str]) -> int:
    if entry.place is TerminalPlace.HERE:
        return _show(entry.load()(Call(words=words)))
    if entry.place is TerminalPlace.HOSTED:
        from simkit.live.session import coming_up

        with coming_up() if _begins_shared_one(words) else contextlib.nullcontext():
            from simkit.cli import (
                terminals,  # with the graph and all: more than a look at a message needs
            )

            return terminals.run_hosted(entry, words)
    if words and words[0] in ("-h", "--help"):
        print(f"usage: simkit {entry.name} COMMAND [ARGUMENTS]\n\n{entry.summary}\n")
        return _show(entry.load()(Call(words=words)))
    from simkit.cli import terminals

    return terminals.elsewhere([entry.name, *words])


def _begins_shared_one(words: Sequence[str]) -> bool:
    """Whether a command that can begin a simulation will, for others to join."""
    from simkit.live.session import PATIENCE, find_session

    own = any(word.partition("=")[0] in _OWN_SIMULATION for word in words)
    return not own and find_session(PATIENCE) is None


def _show(answer: Answer) -> int:
    """Print what a command answers that waits for nothing; its exit code."""
    while True:
        try:
            item = next(answer)
        except StopIteration as end:
            return int(end.value or 0)
        stream = sys.stderr if isinstance(item, ErrorText) else sys.stdout
        stream.write(str(item))
        stream.flush()


def complain(program: str, text: str, code: int = FAILURE) -> int:
    """Print what went wrong, on one line of standard error.

    Args:
        program: Who says it, e.g. `simkit rosmsg`.
        text: What went wrong.
        code: Exit code.

    Returns:
        The exit code.
    """
    print(f"{program}: {' '.join(text.split())}", file=sys.stderr)
    return code


def _unknown(word: str, known: list[str]) -> str:
    near = near_names(word, known)
    meant = f"; did you mean {' or '.join(near)}?" if near else ";"
    return f"no command {word!r}{meant} Commands: {', '.join(known)}"
