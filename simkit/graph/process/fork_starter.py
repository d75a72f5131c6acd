"""Node processes forked from a warm parent: a few milliseconds each. For Linux."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
from collections.abc import Mapping, Sequence
from typing import Any

from simkit.graph.process.readiness import readable
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.starter import (
    START_TIMEOUT,
    StartedProcess,
    Starter,
    StartError,
    clean_environment,
    python_command,
)
from simkit.graph.process.usage import Usage


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
        self._control.settimeout(START_TIMEOUT)
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

    def usage(self, pid: int) -> Usage | None:
        """Through the warm parent."""
        try:
            told = self._request({"do": "usage", "pid": pid})["usage"]
        except StartError:
            return None
        return None if told is None else Usage(**told)

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
