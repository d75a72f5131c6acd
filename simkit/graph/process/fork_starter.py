"""Node processes forked from a fork server (`zygote`): a few milliseconds each. For Linux."""

from __future__ import annotations

import contextlib
import json
import os
import socket
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from simkit.graph.process.fork_server import ForkServer, StartError, clean_environment
from simkit.graph.process.process_tree import Usage
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.starter import StartedProcess, Starter

SIMKIT = str(Path(__file__).resolve().parents[2])
"""Folder of this copy of simkit; that of the nodes is the one that is installed."""


class ForkStarter(Starter):
    """Forks nodes from a fork server, which may live behind a command prefix such as bubblewrap."""

    def __init__(self, command_prefix: Sequence[str], environment: Mapping[str, str]) -> None:
        self._server = ForkServer(
            "simkit.graph.process.zygote",
            environment=clean_environment(environment),
            command_prefix=command_prefix,
            purpose="node processes",
        )
        self._ready = False

    def start(self, spec: StartSpec) -> StartedProcess:
        """Fork a node.

        Raises:
            StartError: The fork server is gone or refuses.
        """
        self._wait_until_ready()
        connection, theirs = socket.socketpair()
        output, output_theirs = os.pipe()
        trace, trace_theirs = os.pipe()
        try:
            request = {"do": "start", "spec": json.loads(spec.to_bytes())}
            answer = self._request(request, [theirs.fileno(), output_theirs, trace_theirs])
        except StartError:
            connection.close()
            for fd in (output, trace):
                os.close(fd)
            raise
        finally:
            theirs.close()
            for fd in (output_theirs, trace_theirs):
                os.close(fd)
        return StartedProcess(connection, output, trace, answer["pid"], self)

    def signal(self, pid: int, number: int) -> None:
        """Through the fork server, which alone knows the process by that id."""
        with contextlib.suppress(StartError):
            self._request({"do": "signal", "pid": pid, "signal": int(number)})

    def usage(self, pid: int) -> Usage | None:
        """Through the fork server."""
        try:
            usage = self._request({"do": "usage", "pid": pid})["usage"]
        except StartError:
            return None
        return None if usage is None else Usage(**usage)

    def end(self, pid: int, *, kill: bool) -> int | None:
        """Through the fork server."""
        try:
            code: int | None = self._request({"do": "end", "pid": pid, "kill": kill})["code"]
        except StartError:
            return None
        return code

    def close(self) -> None:
        """Close the socket of the fork server, at which it kills all nodes and exits."""
        self._server.close()

    @property
    def alive(self) -> bool:
        """Whether the fork server runs."""
        return self._server.alive

    @property
    def server_pid(self) -> int:
        """Process id of the fork server."""
        return self._server.pid

    def _wait_until_ready(self) -> None:
        if self._ready:
            return
        theirs = json.loads(self._server.read_line())["simkit"]
        if theirs != SIMKIT:
            raise StartError(
                f"a node would run the simkit of {theirs}, this simulation that of {SIMKIT}: {sys.executable} "
                "has another copy installed. Run `make` here, and use this copy's own .venv"
            )
        self._ready = True

    def _request(self, request: dict[str, Any], fds: Sequence[int] = ()) -> dict[str, Any]:
        self._server.send(json.dumps(request).encode(), fds)
        answer: dict[str, Any] = json.loads(self._server.read_line())
        if "error" in answer:
            raise StartError(answer["error"])
        return answer
