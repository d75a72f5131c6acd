"""Ways to start a node process: forked from a fork server (`zygote`), or a fresh interpreter.

A fork takes a few milliseconds, on Linux; an interpreter that connects back over loopback works on every platform.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.graph.process.fork_server import (
    START_TIMEOUT,
    ForkServer,
    StartError,
    clean_environment,
    python_command,
)
from simkit.graph.process.process_tree import Usage, usage_of
from simkit.graph.process.spec import StartSpec

SIMKIT = str(Path(__file__).resolve().parents[2])
"""Folder of this copy of simkit; that of the nodes is the one that is installed."""
_LOOK = 0.2
"""How often to look whether a process that was started still lives [s]."""


@dataclass(slots=True)
class StartedProcess:
    """A node process as its starter hands it out."""

    connection: socket.socket
    """Connected to the node; non-blocking reads are the holder's business."""
    output: socket.socket | int
    """Where its standard output and error arrive: something that can be polled."""
    trace_fd: int | None
    """Where its stack arrives after `ask_stack`."""
    pid: int
    """Process id, as its starter knows it."""
    starter: Starter
    """Who can signal and end it."""

    def ask_stack(self) -> None:
        """Ask a stuck process to write its stack to `trace_fd`."""
        if hasattr(signal, "SIGUSR1"):
            self.starter.signal(self.pid, signal.SIGUSR1)

    def usage(self) -> Usage | None:
        """How much of a processor it has had; None if nobody can tell."""
        return self.starter.usage(self.pid)

    def end(self, *, kill: bool) -> int | None:
        """Reap it and all that it left behind; its exit code, negative for a signal, None if unknown."""
        return self.starter.end(self.pid, kill=kill)


class Starter(ABC):
    """A way to start node processes."""

    @abstractmethod
    def start(self, spec: StartSpec) -> StartedProcess:
        """Start a node process."""

    @abstractmethod
    def signal(self, pid: int, number: int) -> None:
        """Send a signal to a node process."""

    @abstractmethod
    def usage(self, pid: int) -> Usage | None:
        """How much of a processor a node process has had; None if nobody can tell."""

    @abstractmethod
    def end(self, pid: int, *, kill: bool) -> int | None:
        """Reap a node process, killed first if asked."""

    @abstractmethod
    def close(self) -> None:
        """End everything that was started."""


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


class SpawnStarter(Starter):
    """Starts each node as a fresh interpreter that connects back over loopback; needs nothing but sockets."""

    def __init__(self, command_prefix: Sequence[str], environment: Mapping[str, str]) -> None:
        self._prefix = list(command_prefix)
        self._environment = clean_environment(environment)
        self._processes: dict[int, subprocess.Popen[bytes]] = {}

    def start(self, spec: StartSpec) -> StartedProcess:
        """Start an interpreter, hand it the specification, and let it run.

        Raises:
            StartError: It does not come to life.
        """
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.settimeout(_LOOK)
            token = os.urandom(16).hex()
            process = self._launch(server.getsockname()[1])
            assert process.stdin is not None
            assert process.stdout is not None
            with contextlib.suppress(OSError), process.stdin:  # who died at once is found below
                process.stdin.write(token.encode() + b"\n" + spec.to_bytes())
            try:
                connection = self._accept(server, token, process)
            except StartError:
                process.kill()
                process.wait()
                process.stdout.close()
                raise
        self._processes[process.pid] = process
        with process.stdout:
            output = _as_socket(os.dup(process.stdout.fileno()))
        return StartedProcess(connection, output, None, process.pid, self)

    def _launch(self, port: int) -> subprocess.Popen[bytes]:
        command = [*self._prefix, *python_command("simkit.graph.process.child", str(port))]
        try:
            return subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env=self._environment,
                start_new_session=True,
            )
        except OSError as error:
            raise StartError(f"cannot start {command[0]}: {error.strerror}") from error

    def signal(self, pid: int, number: int) -> None:
        """Directly."""
        self._processes[pid].send_signal(number)

    def usage(self, pid: int) -> Usage | None:
        """Directly."""
        return usage_of(pid)

    def end(self, pid: int, *, kill: bool) -> int | None:
        """Reap it; what it started in its own session ends with it where the platform has sessions."""
        process = self._processes.pop(pid)
        if kill:
            process.kill()
        try:
            code = process.wait(timeout=5)
        except subprocess.TimeoutExpired:
            process.kill()
            code = process.wait()
        if hasattr(os, "killpg"):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(pid, signal.SIGKILL)
        return code

    def close(self) -> None:
        """Kill them all."""
        for pid in list(self._processes):
            self.end(pid, kill=True)

    @staticmethod
    def _accept(
        server: socket.socket, token: str, process: subprocess.Popen[bytes]
    ) -> socket.socket:
        # Anybody on this machine can connect to the port: only who knows the token is our node.
        deadline = time.monotonic() + START_TIMEOUT
        while True:
            try:
                connection, _ = server.accept()
            except TimeoutError:
                if process.poll() is not None or time.monotonic() > deadline:
                    raise StartError(_epitaph(process)) from None
                continue
            connection.settimeout(START_TIMEOUT)
            with contextlib.suppress(OSError):
                if connection.recv(32, socket.MSG_WAITALL) == token.encode():
                    connection.settimeout(None)
                    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    return connection
            connection.close()


def _epitaph(process: subprocess.Popen[bytes]) -> str:
    if process.returncode is None:
        return f"the node process did not start within {START_TIMEOUT:g} s"
    assert process.stdout is not None
    said = process.stdout.read(4000).decode(errors="replace").strip().splitlines()
    last = said[-1] if said else "no word"
    return f"the node process has died at once (exit code {process.returncode}): {last}"


def _as_socket(fd: int) -> socket.socket:
    """A socket that carries what arrives on a pipe, which it owns: Windows can wait for sockets only."""
    ours, theirs = socket.socketpair()

    def forward() -> None:
        with contextlib.suppress(OSError), theirs:
            while data := os.read(fd, 65536):
                theirs.sendall(data)
        os.close(fd)

    threading.Thread(target=forward, name="node output", daemon=True).start()
    return ours
