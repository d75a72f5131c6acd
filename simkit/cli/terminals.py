"""One simulation for all terminals: host it here, or do a command in the one that another terminal hosts."""

from __future__ import annotations

import argparse
import socket
import sys
from collections.abc import Callable, Sequence
from typing import Any

from simkit.cli.pace import Interrupt, run_for_a_person
from simkit.commands.command import Call, ErrorText
from simkit.commands.errors import FAILURE, USAGE_ERROR
from simkit.commands.graph_facts import nodes
from simkit.commands.parser import LineParser
from simkit.commands.rosrun import LAST_WORDS
from simkit.commands.table import COMMANDS, Entry, TerminalPlace
from simkit.diagnostics import Layout
from simkit.errors import SimkitError
from simkit.live.client import run_in_session
from simkit.live.host import Host
from simkit.live.job import Job
from simkit.live.session import PATIENCE, Session, SessionError, find_session
from simkit.packages import PackagePath
from simkit.simulation import Simulation

_CONNECT_TIMEOUT = 2.0
_ROS_USAGE_ERROR = 64  # what the tools of ROS end with
_JOINABLE = ("rosrun", "roslaunch")


def run_hosted(entry: Entry, words: Sequence[str]) -> int:
    """Do a command in the simulation of another terminal, or in one that is hosted here; its exit code.

    Args:
        entry: A command that can begin a simulation.
        words: The words after its name.
    """
    from simkit.launch import LaunchError

    try:
        return _run_hosted(entry, words)
    except LaunchError as error:  # roslaunch's own words have several lines
        print(error.text(Layout.of(sys.stderr)), file=sys.stderr)
    except SessionError as error:
        if entry.name != "roslaunch":
            raise
        print(error, file=sys.stderr)
    return FAILURE


def _run_hosted(entry: Entry, words: Sequence[str]) -> int:
    module: Any = entry.load_module()
    program = f"simkit {entry.name}"
    parser = LineParser(
        program, description=entry.summary, usage=module.USAGE, epilog=module.EPILOG
    )
    module.add_options(parser)
    module.add_arguments(parser)
    arguments = parser.parse_args(words)
    rest = _take_options(arguments, arguments.words, module.add_options, program=program)
    own = module.own_words(arguments, rest)
    alone = entry.name in _JOINABLE and _wants_own_simulation(arguments)
    if not alone and running_session() is not None:
        if entry.name not in _JOINABLE:
            raise SimkitError(
                "it cannot run here: a simulation is running already in another terminal"
            )
        return elsewhere([entry.name, *own])
    return _run_here(entry, own, arguments, alone=alone)


def _wants_own_simulation(arguments: argparse.Namespace) -> bool:
    """Whether an option asks for a simulation that nobody else joins."""
    return bool(arguments.fast or arguments.seconds is not None or arguments.seed is not None)


def _take_options(
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
        add_options: Adds the options to a parser.
        program: Who complains, e.g. `simkit rosrun`.
    """
    at = words.index("--") if "--" in words else len(words)
    parser = LineParser(program, add_help=False, argument_default=argparse.SUPPRESS)
    add_options(parser)
    _, own = parser.parse_known_args(words[:at], arguments)
    return own + words[at + 1 :]


def _run_here(
    entry: Entry, words: Sequence[str], arguments: argparse.Namespace, *, alone: bool
) -> int:
    others = "" if alone else "; other terminals join it; Ctrl-C ends it"
    with Simulation(arguments.seed or 0, screen=None) as sim:
        job = Job(
            Call(
                simulation=sim,
                words=words,
                show_window=sim.serve_window_of,
                opening=f"started a simulation{others}\n\n",
                hosts=not alone,
            ),
            entry.load(),
        )
        with job.keys_of_this_terminal() as hand_over:

            def is_over() -> bool:
                hand_over()
                for text in job.poll():
                    show(text)
                return job.exit_code is not None

            if alone:
                end = run_for_a_person(sim, is_over, seconds=arguments.seconds, fast=arguments.fast)
            else:
                end = "interrupted" if host(sim, is_over) else "over"
            if end == "interrupted":
                job.interrupt()
                sim.run_until(is_over, timeout=LAST_WORDS)
            if end == "idle":
                names = nodes(sim.graph)
                wait = "waits" if len(names) == 1 else "wait"
                print(
                    f"{', '.join(names)} {wait} for ever: nothing else runs here", file=sys.stderr
                )
        return job.exit_code or 0


def host(sim: Simulation, until: Callable[[], bool]) -> bool:
    """Host a simulation until `until()` holds or Ctrl-C comes; whether Ctrl-C ended it."""
    interrupt = Interrupt()
    joinable = {
        name: lambda call, entry=entry: entry.load()(call)
        for name, entry in COMMANDS.items()
        if entry.place is TerminalPlace.SHARED or name in _JOINABLE
    }
    with interrupt.caught():
        Host(sim, joinable).serve(lambda: interrupt.came or until())
    return interrupt.came


def running_session(patience: float = 0.0) -> Session | None:
    """The session that is announced, if it answers; a host that was killed leaves its file.

    Args:
        patience: How long to wait for one that is coming up [s].
    """
    session = find_session(patience)
    if session is None:
        return None
    try:
        socket.create_connection(("127.0.0.1", session.port), _CONNECT_TIMEOUT).close()
    except OSError:
        return None
    return session


def elsewhere(argv: Sequence[str]) -> int:
    """Do a command in the simulation of another terminal, and show what it says.

    Args:
        argv: Command and arguments, e.g. `["rostopic", "echo", "/tf"]`.

    Returns:
        Its exit code; Ctrl-C is the usual end of a command that goes on.

    Raises:
        SessionError: No simulation runs.
    """
    session = running_session(PATIENCE)
    if session is None:
        raise SessionError(
            "no simulation runs; start one in another terminal: simkit roscore, or simkit rosrun ..."
        )
    try:
        code = run_in_session(session, argv, show, folders=_folders_for(argv[0]))
    except KeyboardInterrupt:
        return 0
    return USAGE_ERROR if code == _ROS_USAGE_ERROR else code


def _folders_for(command: str) -> list[str]:
    """Folders of packages of this terminal, for the commands that start something from them."""
    if command not in ("rosrun", "roslaunch"):
        return []
    return [str(folder) for folder in PackagePath().folders]


def show(text: str) -> None:
    """Print what a command says, at once."""
    stream = sys.stderr if isinstance(text, ErrorText) else sys.stdout
    stream.write(text)
    stream.flush()
