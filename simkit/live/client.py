"""What a terminal says to the running simulation, and how it shows the answer."""

from __future__ import annotations

import contextlib
import json
import socket
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from simkit.commands.command import ErrorText
from simkit.live.keyboard import PERIOD, Keyboard
from simkit.live.session import Session, SessionError

_CONNECT_TIMEOUT = 5.0
_ENDED = "the simulation of the other terminal has ended"


def run_in_session(
    session: Session,
    argv: Sequence[str],
    show: Callable[[str], None],
    *,
    folders: Sequence[str] = (),
) -> int:
    """Give a command to a running simulation and show what it says until it ends.

    Args:
        session: Where the simulation listens.
        argv: Command and arguments, e.g. `["rostopic", "echo", "/tf"]`.
        show: Takes each piece of output; what belongs on standard error is an `ErrorText`.
        folders: Where this terminal has its packages: the simulation looks there, too.

    Files that the command names without a folder are in the folder of this process.
    If the command reads keys, those of this process's terminal are sent to it.

    Returns:
        The command's exit code.

    Raises:
        SessionError: The simulation does not answer, ends meanwhile, or refuses; the text says why.
    """
    try:
        connection = socket.create_connection(("127.0.0.1", session.port), _CONNECT_TIMEOUT)
    except OSError as error:
        raise SessionError(_ENDED) from error
    request = {
        "token": session.token,
        "argv": list(argv),
        "here": str(Path.cwd()),
        "folders": list(folders),
    }
    with connection, contextlib.ExitStack() as at_the_end:
        connection.settimeout(None)  # a command such as echo speaks when there is something to say
        _send(connection, request)
        keyboard = Keyboard()
        for answer in _answers(connection, keyboard):
            if "error" in answer:
                raise SessionError(answer["error"])
            if "keys" in answer:
                at_the_end.enter_context(keyboard.reading())
                connection.settimeout(PERIOD)
            if "out" in answer:
                show(answer["out"])
            if "err" in answer:
                show(ErrorText(answer["err"]))
            if "exit" in answer:
                return int(answer["exit"])
    raise SessionError(_ENDED)


def _answers(connection: socket.socket, keyboard: Keyboard) -> Iterator[dict[str, Any]]:
    """The lines of the host; the keys pressed meanwhile are sent."""
    data = b""
    while True:
        try:
            for key in keyboard.pressed():
                _send(connection, {"key": key})
            received = connection.recv(65536)
        except TimeoutError:
            continue
        except OSError:
            return
        if not received:
            return
        *lines, data = (data + received).split(b"\n")
        yield from map(json.loads, lines)


def _send(connection: socket.socket, value: dict[str, Any]) -> None:
    connection.sendall(json.dumps(value).encode() + b"\n")
