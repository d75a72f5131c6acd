"""One simulation for all terminals: host it here, or do a command in the one that another terminal hosts."""

from __future__ import annotations

import socket
import sys
from collections.abc import Callable, Sequence

from simkit.cli.complaint import USAGE_ERROR
from simkit.cli.interrupt import Interrupt
from simkit.graph import LogRecord
from simkit.graph.screen import Screen
from simkit.live import Host, Session, SessionError, call, find_session
from simkit.live.commands import live_commands
from simkit.packages import PackagePath
from simkit.simulation import Simulation

_CONNECT_TIMEOUT = 2.0
_ROS_USAGE_ERROR = 64  # what the tools of ROS end with


def host(sim: Simulation, until: Callable[[], bool]) -> bool:
    """Host a simulation until `until()` holds or Ctrl-C comes; whether Ctrl-C ended it."""
    interrupt = Interrupt()
    with interrupt.caught():
        Host(sim, live_commands()).serve(lambda: interrupt.came or until())
    return interrupt.came


class OnlyFrom:
    """A screen for some nodes: what the others say belongs into their own terminals.

    Args:
        is_meant: Whether a node of that name is one of them.
        screen: Where it is shown.
    """

    def __init__(self, is_meant: Callable[[str], bool], screen: Screen) -> None:
        self._is_meant = is_meant
        self._screen = screen

    def record(self, record: LogRecord) -> None:
        """Show their lines of rosout."""
        if self._is_meant(record.node):
            self._screen.record(record)

    def output(self, node: str, text: str) -> None:
        """Show what they print."""
        if self._is_meant(node):
            self._screen.output(node, text)


def running_session() -> Session | None:
    """The session that is announced, if somebody listens there; a host that was killed leaves its file."""
    session = find_session()
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
    session = running_session()
    if session is None:
        raise SessionError(
            "no simulation runs; start one in another terminal: simkit roscore, or simkit rosrun ..."
        )
    try:
        code = call(session, argv, show, folders=_folders_for(argv[0]))
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
    sys.stdout.write(text)
    sys.stdout.flush()
