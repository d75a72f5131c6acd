"""Runs a simulation at the pace of the wall clock and does what other terminals ask.

A terminal and its host exchange lines of JSON. The terminal begins with its request: `token`, `argv`, and in which folders
`here` and `folders` it stands. The host answers with `{"out": text}`, or `{"err": text}` for standard error, as often as
there is something to show, once with `{"keys": true}` if the command reads the keyboard, and with `{"exit": code}` at the
end; `{"error": text, "exit": code}` refuses. A terminal that was asked for keys sends `{"key": "up"}` for each. Whoever
closes the connection ends the command.
"""

from __future__ import annotations

import contextlib
import json
import os
import secrets
import selectors
import socket
import time
from collections.abc import Callable, Mapping, Sequence

from simkit.commands.command import Call, Command, ErrorText
from simkit.errors import SimkitError, UnknownNameError
from simkit.live.job import Job
from simkit.live.session import Session, announced
from simkit.simulation import Simulation

SLICE = 0.02
"""Longest wall time between two slices of virtual time [s]."""
MAX_REQUEST = 1_000_000
"""Longest request [bytes]."""


class _Terminal:
    """A connection from another terminal: first a request, then the job that it began."""

    def __init__(self, connection: socket.socket) -> None:
        self.connection = connection
        self.data = b""
        self.job: Job | None = None

    def say(self, **value: object) -> bool:
        """Send one line; whether the terminal still listens."""
        try:
            self.connection.settimeout(1.0)
            self.connection.sendall(json.dumps(value).encode() + b"\n")
        except OSError:
            return False
        return True


class Host:
    """Hosts one simulation.

    Args:
        sim: The simulation.
        commands: What terminals may ask for, by name.
        rate: Virtual seconds per second of wall time.
    """

    def __init__(self, sim: Simulation, commands: Mapping[str, Command], rate: float = 1.0) -> None:
        self._sim = sim
        self._commands = commands
        self._rate = rate
        self._token = secrets.token_hex(16)
        self._selector = selectors.DefaultSelector()
        self._terminals: list[_Terminal] = []

    def serve(self, until: Callable[[], bool]) -> None:
        """Run the simulation, and answer, until `until()` holds or Ctrl-C is pressed."""
        with socket.create_server(("127.0.0.1", 0)) as server:
            session = Session(port=server.getsockname()[1], token=self._token, pid=os.getpid())
            self._selector.register(server, selectors.EVENT_READ)
            with announced(session), contextlib.suppress(KeyboardInterrupt):
                self._pace(server, until)
        for terminal in list(self._terminals):
            self._drop(terminal)

    def begin(self, argv: Sequence[str]) -> Job:
        """Begin a command.

        Raises:
            SimkitError: There is no such command, or it cannot be done.
        """
        if not argv or argv[0] not in self._commands:
            raise UnknownNameError("command", argv[0] if argv else "", self._commands)
        call = Call(
            simulation=self._sim,
            words=list(argv[1:]),
            show_window=self._sim.serve_window_of,
            opening="joined the simulation of another terminal\n\n",
        )
        return Job(call, self._commands[argv[0]])

    def _pace(self, server: socket.socket, until: Callable[[], bool]) -> None:
        start, virtual = time.monotonic(), 0.0
        while not until():
            due = (time.monotonic() - start) * self._rate
            self._sim.run(max(0.0, due - virtual))
            virtual = max(virtual, due)
            for terminal in list(self._terminals):
                self._report(terminal)
            for key, _ in self._selector.select(SLICE):
                if key.fileobj is server:
                    self._accept(server)
                else:
                    self._hear(key.data)

    def _accept(self, server: socket.socket) -> None:
        connection, _ = server.accept()
        terminal = _Terminal(connection)
        self._terminals.append(terminal)
        self._selector.register(connection, selectors.EVENT_READ, terminal)

    def _hear(self, terminal: _Terminal) -> None:
        try:
            data = terminal.connection.recv(65536)
        except OSError:
            data = b""
        terminal.data += data
        if not data or len(terminal.data) > MAX_REQUEST:
            self._drop(terminal)
        while terminal in self._terminals and b"\n" in terminal.data:
            line, _, terminal.data = terminal.data.partition(b"\n")
            if terminal.job is None:
                self._begin_for(terminal, line)
            else:
                _press(terminal.job, line)

    def _begin_for(self, terminal: _Terminal, line: bytes) -> None:
        try:
            request = json.loads(line)
            allowed = secrets.compare_digest(str(request["token"]), self._token)
            argv = [str(word) for word in request["argv"]]
            here = str(request["here"])
            folders = [str(folder) for folder in request["folders"]]
        except (ValueError, KeyError, TypeError, RecursionError):
            allowed = False
        if not allowed:
            self._drop(terminal)
            return
        self._sim.packages.prefer(folders)
        try:
            with contextlib.chdir(here):  # what the terminal names is in its folder
                terminal.job = self.begin(argv)
        except (SimkitError, OSError) as error:
            terminal.say(error=str(error), exit=1)
            self._drop(terminal)
            return
        if terminal.job.takes_keys:
            terminal.say(keys=True)
        self._report(terminal)

    def _report(self, terminal: _Terminal) -> None:
        if terminal.job is None:
            return
        listening = True
        for text in filter(None, terminal.job.poll()):
            stream = "err" if isinstance(text, ErrorText) else "out"
            listening = terminal.say(**{stream: text}) and listening
        if terminal.job.exit_code is not None:
            terminal.say(exit=terminal.job.exit_code)
            listening = False
        if not listening:
            self._drop(terminal)

    def _drop(self, terminal: _Terminal) -> None:
        if terminal not in self._terminals:
            return
        self._terminals.remove(terminal)
        self._selector.unregister(terminal.connection)
        terminal.connection.close()
        if terminal.job is not None and terminal.job.exit_code is None:
            terminal.job.cancel()


def _press(job: Job, line: bytes) -> None:
    with contextlib.suppress(ValueError, KeyError, TypeError, RecursionError):
        job.press(str(json.loads(line)["key"]))
