"""Node processes as fresh interpreters, connected over loopback: for every platform, and slower."""

from __future__ import annotations

import contextlib
import os
import signal
import socket
import subprocess
import threading
from collections.abc import Mapping, Sequence

from simkit.graph.process.spec import StartSpec
from simkit.graph.process.starter import (
    START_TIMEOUT,
    StartedProcess,
    Starter,
    StartError,
    clean_environment,
    python_command,
)


class SpawnStarter(Starter):
    """Starts each node as a fresh interpreter that connects back over loopback; needs nothing but sockets."""

    def __init__(self, command_prefix: Sequence[str], environment: Mapping[str, str]) -> None:
        self._prefix = list(command_prefix)
        self._environment = clean_environment(environment)
        self._processes: dict[int, subprocess.Popen[bytes]] = {}

    def start(self, spec: StartSpec) -> StartedProcess:
        """Start an interpreter, hand it the specification, and let it run."""
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.settimeout(START_TIMEOUT)
            token = os.urandom(16).hex()
            port = server.getsockname()[1]
            process = subprocess.Popen(
                [*self._prefix, *python_command("simkit.graph.process.spawned", str(port))],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env=self._environment,
                start_new_session=True,
            )
            assert process.stdin is not None
            assert process.stdout is not None
            with process.stdin:
                process.stdin.write(token.encode() + b"\n" + spec.to_bytes())
            connection = self._accept(server, token, process)
        self._processes[process.pid] = process
        with process.stdout:
            output = _as_socket(os.dup(process.stdout.fileno()))
        return StartedProcess(connection, output, None, process.pid, self)

    def signal(self, pid: int, number: int) -> None:
        """Directly."""
        self._processes[pid].send_signal(number)

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
        while True:
            try:
                connection, _ = server.accept()
            except OSError as error:
                process.kill()
                raise StartError("the node process did not start in time") from error
            connection.settimeout(START_TIMEOUT)
            with contextlib.suppress(OSError):
                if connection.recv(32, socket.MSG_WAITALL) == token.encode():
                    connection.settimeout(None)
                    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                    return connection
            connection.close()


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
