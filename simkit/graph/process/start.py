"""How a node process comes into being: forked from a warm parent, or, where there is no fork, as a fresh interpreter.

Both give a `StartedProcess`; nothing else in simkit knows the difference.
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
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError
from simkit.graph.process.readiness import readable
from simkit.graph.process.spec import StartSpec

HAS_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds") and sys.platform != "darwin"
"""macOS can fork, but its system libraries do not survive it: a fresh interpreter is right there."""
_START_TIMEOUT = 30.0


class StartError(SimkitError):
    """A node process, or the warm parent of node processes, cannot be started."""


@dataclass(slots=True)
class StartedProcess:
    """A node process as its starter hands it out."""

    connection: socket.socket
    """Connected to the node; non-blocking reads are the holder's business."""
    output: socket.socket | int
    """Where its standard output and error arrive: something `select` takes."""
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
    def end(self, pid: int, *, kill: bool) -> int | None:
        """Reap a node process, killed first if asked."""

    @abstractmethod
    def close(self) -> None:
        """End everything that was started."""


def clean_environment(extra: Mapping[str, str]) -> dict[str, str]:
    """The environment of node processes: the same on every machine, and no secret in it."""
    environment = {
        "PATH": "/usr/local/bin:/usr/bin:/bin",
        "LANG": "C.UTF-8",
        "TZ": "UTC",
        "PYTHONHASHSEED": "0",
        "PYTHONDONTWRITEBYTECODE": "1",
        "PYTHONIOENCODING": "utf-8",
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
        "MPLBACKEND": "Agg",
    }
    for name in ("SYSTEMROOT", "TEMP", "TMP"):  # Windows cannot start Python without the first
        if name in os.environ:
            environment[name] = os.environ[name]
    environment.update(extra)
    return environment


def python_command(module: str, *arguments: str) -> list[str]:
    """Command line that runs a module of ours in a fresh interpreter of this installation."""
    return [sys.executable, "-s", "-P", "-m", module, *arguments]


class ForkStarter(Starter):
    """Forks nodes from a warm parent (`zygote`), which may live behind a command prefix such as bubblewrap."""

    def __init__(self, command_prefix: Sequence[str], environment: Mapping[str, str]) -> None:
        ours, theirs = socket.socketpair()
        with theirs:
            os.set_inheritable(theirs.fileno(), True)
            command = [
                *command_prefix,
                *python_command("simkit.graph.process.zygote", str(theirs.fileno())),
            ]
            try:
                self._process = subprocess.Popen(
                    command,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.PIPE,
                    env=clean_environment(environment),
                    pass_fds=[theirs.fileno()],
                    start_new_session=True,
                )
            except OSError as error:
                ours.close()
                raise StartError(f"cannot start {command[0]}: {error.strerror}") from error
        self._control = ours
        self._control.settimeout(_START_TIMEOUT)
        self._ready = False
        self._pending = b""

    def start(self, spec: StartSpec) -> StartedProcess:
        """Fork a node.

        Raises:
            StartError: The warm parent is gone or refuses.
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
        """Through the warm parent, which alone knows the process by that id."""
        with contextlib.suppress(StartError):
            self._request({"do": "signal", "pid": pid, "signal": int(number)})

    def end(self, pid: int, *, kill: bool) -> int | None:
        """Through the warm parent."""
        try:
            status = self._request({"do": "end", "pid": pid, "kill": kill})["status"]
        except StartError:
            return None
        return None if status is None else os.waitstatus_to_exitcode(status)

    def close(self) -> None:
        """Close the control socket, at which the warm parent kills all nodes and exits."""
        self._control.close()
        try:
            self._process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self._kill()
        if self._process.stderr is not None:
            self._process.stderr.close()

    @property
    def alive(self) -> bool:
        """Whether the warm parent runs."""
        return self._process.poll() is None

    def _kill(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def _wait_until_ready(self) -> None:
        if not self._ready:
            self._read_answer()
            self._ready = True

    def _request(self, request: dict[str, Any], fds: Sequence[int] = ()) -> dict[str, Any]:
        try:
            socket.send_fds(self._control, [json.dumps(request).encode()], list(fds))
        except OSError as error:
            raise StartError(self._epitaph()) from error
        return self._read_answer()

    def _read_answer(self) -> dict[str, Any]:
        while b"\n" not in self._pending:
            try:
                data = self._control.recv(65536)
            except OSError as error:
                raise StartError(self._epitaph()) from error
            if not data:
                raise StartError(self._epitaph())
            self._pending += data
        line, _, self._pending = self._pending.partition(b"\n")
        answer: dict[str, Any] = json.loads(line)
        if "error" in answer:
            raise StartError(answer["error"])
        return answer

    def _epitaph(self) -> str:
        """Why the warm parent is gone, from what it said last."""
        self._kill()
        said = ""
        if self._process.stderr is not None and not self._process.stderr.closed:
            fd = self._process.stderr.fileno()
            if readable([fd], 0.5):
                said = os.read(fd, 4000).decode(errors="replace")
        last = said.strip().splitlines()[-1:] or ["no word"]
        return f"the parent of the node processes has died (exit code {self._process.returncode}): {last[0]}"


class SpawnStarter(Starter):
    """Starts each node as a fresh interpreter that connects back over loopback; needs nothing but sockets."""

    def __init__(self, command_prefix: Sequence[str], environment: Mapping[str, str]) -> None:
        self._prefix = list(command_prefix)
        self._environment = clean_environment(environment)
        self._processes: dict[int, subprocess.Popen[bytes]] = {}

    def start(self, spec: StartSpec) -> StartedProcess:
        """Start an interpreter, hand it the specification, and let it run."""
        with socket.create_server(("127.0.0.1", 0)) as server:
            server.settimeout(_START_TIMEOUT)
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
            connection.settimeout(_START_TIMEOUT)
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


def default_starter(
    command_prefix: Sequence[str], environment: Mapping[str, str], method: str | None = None
) -> Starter:
    """The quickest starter that works here: `fork` on Linux, `spawn` elsewhere, or the one asked for."""
    method = method or ("fork" if HAS_FORK else "spawn")
    kind = {"fork": ForkStarter, "spawn": SpawnStarter}[method]
    return kind(command_prefix, environment)
