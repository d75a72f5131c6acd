"""Node processes as fresh interpreters, connected over loopback: for every platform, and slower."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import subprocess
import threading
import time
from collections.abc import Mapping, Sequence

from simkit.graph.process.fork_server import (
    START_TIMEOUT,
    StartError,
    clean_environment,
    python_command,
)
from simkit.graph.process.process_tree import Usage, usage_of
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.starter import StartedProcess, Starter

_LOOK = 0.2
"""How often to look whether a process that was started still lives [s]."""


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
