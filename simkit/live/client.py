"""What a terminal says to the running simulation, and how it shows the answer."""

from __future__ import annotations

import json
import socket
from collections.abc import Callable, Sequence
from pathlib import Path

from simkit.live.session import Session, SessionError

_CONNECT_TIMEOUT = 5.0


def call(
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
        show: Takes each piece of output.
        folders: Where this terminal has its packages: the simulation looks there, too.

    Files that the command names without a folder are in the folder of this process.

    Returns:
        The command's exit code.

    Raises:
        SessionError: The simulation does not answer, ends meanwhile, or refuses; the text says why.
    """
    try:
        connection = socket.create_connection(("127.0.0.1", session.port), _CONNECT_TIMEOUT)
    except OSError as error:
        raise SessionError("the simulation of the other terminal has ended") from error
    with connection:
        connection.settimeout(None)  # a command such as echo speaks when there is something to say
        request = {
            "token": session.token,
            "argv": list(argv),
            "here": str(Path.cwd()),
            "folders": list(folders),
        }
        connection.sendall(json.dumps(request).encode() + b"\n")
        with connection.makefile("r", encoding="utf-8") as lines:
            for line in lines:
                answer = json.loads(line)
                if "error" in answer:
                    raise SessionError(answer["error"])
                if "out" in answer:
                    show(answer["out"])
                if "exit" in answer:
                    return int(answer["exit"])
    raise SessionError("the simulation of the other terminal has ended")
