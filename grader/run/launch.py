"""Start checker processes: forked from a fork server, or, where there is no fork, a fresh Python.

The fork server imports pytest and simkit once; a checker then starts in a few milliseconds. It is
ours, not multiprocessing's, since that would import the caller's own script in every checker, and
a student may call `check` from one.
"""

from __future__ import annotations

import atexit
import contextlib
import functools
import json
import os
import signal
import socket
import subprocess
import tempfile
import threading
from collections.abc import Callable
from io import BufferedReader
from typing import Protocol

from grader.errors import GraderError
from grader.run.supervise import Checker
from simkit.graph.process import (
    HAS_FORK,
    ForkServer,
    StartError,
    clean_environment,
    python_command,
)

LENGTH_BYTES = 8
"""A job travels as its length, big-endian, and its bytes."""
_END_SECONDS = 10.0


class Launcher(Protocol):
    """A way to start checker processes."""

    def start(self, job: bytes) -> Checker:
        """Start a checker on a job."""

    def close(self) -> None:
        """End every checker, and whatever was kept warm."""


def framed(job: bytes) -> bytes:
    """A job as it travels."""
    return len(job).to_bytes(LENGTH_BYTES, "big") + job


def read_framed(read: Callable[[int], bytes]) -> bytes | None:
    """A job as it arrives; None if the other end closes before it is complete.

    Args:
        read: Returns at most so many bytes; none at the end.
    """
    data = bytearray()
    wanted = LENGTH_BYTES
    while len(data) < wanted:
        piece = read(min(wanted - len(data), 1 << 20))
        if not piece:
            return None
        data += piece
        if len(data) == wanted == LENGTH_BYTES:
            wanted += int.from_bytes(data, "big")
    return bytes(data[LENGTH_BYTES:])


def checker_environment() -> dict[str, str]:
    """The environment of checkers: the same on every machine, and nothing of the caller's."""
    extra = {
        "HOME": tempfile.gettempdir(),
        "PYTHONUTF8": "1",
        "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
        "MPLCONFIGDIR": tempfile.gettempdir(),
    }
    if "TMPDIR" in os.environ:
        extra["TMPDIR"] = os.environ["TMPDIR"]
    return clean_environment(extra)


class WarmLauncher:
    """Forks checkers from one fork server, started when first needed, replaced if it dies."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._server: ForkServer | None = None
        self._running: set[_ForkedChecker] = set()
        self._closed = False

    def start(self, job: bytes) -> Checker:
        """Fork a checker.

        Raises:
            GraderError: No fork server can be started.
        """
        lifeline, theirs = socket.socketpair()
        results, results_theirs = os.pipe()
        output, output_theirs = os.pipe()
        try:
            self._send([theirs.fileno(), results_theirs, output_theirs])
        except GraderError:
            lifeline.close()
            os.close(results)
            os.close(output)
            raise
        finally:
            theirs.close()
            os.close(results_theirs)
            os.close(output_theirs)
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):
            lifeline.sendall(framed(job))
        checker = _ForkedChecker(
            lifeline, os.fdopen(results, "rb"), os.fdopen(output, "rb"), self._running.discard
        )
        self._running.add(checker)
        return checker

    @property
    def server_pid(self) -> int | None:
        """Process id of the fork server; None before the first job."""
        return self._server.pid if self._server is not None else None

    def close(self) -> None:
        """End the fork server and every checker that came from it; nothing starts afterwards."""
        with self._lock:
            self._closed = True
            for checker in list(self._running):
                checker.kill()
            self._stop()

    def _send(self, fds: list[int]) -> None:
        with self._lock:
            if self._closed:
                raise GraderError("grading was stopped")
            for attempt in (1, 2):
                try:
                    self._living_server().send(b"j", fds)
                    return
                except StartError as error:
                    self._stop()
                    if attempt == 2:
                        raise GraderError(f"no checker process can be started: {error}") from error

    def _living_server(self) -> ForkServer:
        if self._server is None or not self._server.alive:
            self._stop()
            self._server = ForkServer(
                "grader.run.warm",
                environment=checker_environment(),
                purpose="checkers",
                stderr=None,
            )
        return self._server

    def _stop(self) -> None:
        if self._server is not None:
            self._server.close()
        self._server = None


class _ForkedChecker:
    """A checker behind a guard: closing the lifeline makes the guard kill all that came from it."""

    def __init__(
        self,
        lifeline: socket.socket,
        results: BufferedReader,
        output: BufferedReader,
        on_end: Callable[[_ForkedChecker], None],
    ) -> None:
        self.results = results
        self.output = output
        self._lifeline = lifeline
        self._on_end = on_end
        self._lifeline.settimeout(_END_SECONDS)

    def kill(self) -> None:
        with contextlib.suppress(OSError):
            self._lifeline.shutdown(socket.SHUT_WR)

    def wait(self) -> int | None:
        self._on_end(self)
        with self._lifeline:
            try:
                text = self._lifeline.recv(100)
                return int(json.loads(text)["exit_code"])
            except (OSError, ValueError, KeyError):
                return None


class SpawnLauncher:
    """Starts each checker as a fresh Python; slower, and possible everywhere."""

    def __init__(self) -> None:
        self._running: set[_SpawnedChecker] = set()

    def start(self, job: bytes) -> Checker:
        """Start a checker."""
        process = subprocess.Popen(
            python_command("grader.run.checker"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=checker_environment(),
            start_new_session=True,
        )
        checker = _SpawnedChecker(process, self._running.discard)
        self._running.add(checker)
        assert process.stdin is not None
        with contextlib.suppress(OSError):
            process.stdin.write(framed(job))
            process.stdin.flush()
        return checker

    def close(self) -> None:
        """Kill every checker."""
        for checker in list(self._running):
            checker.kill()


class _SpawnedChecker:
    """A checker in a session of its own, whose standard input is its lifeline."""

    def __init__(
        self, process: subprocess.Popen[bytes], on_end: Callable[[_SpawnedChecker], None]
    ) -> None:
        assert isinstance(process.stdout, BufferedReader)
        assert isinstance(process.stderr, BufferedReader)
        self.results = process.stdout
        self.output = process.stderr
        self._process = process
        self._on_end = on_end

    def kill(self) -> None:
        if self._process.poll() is None:
            self._process.kill()
        if hasattr(os, "killpg"):
            with contextlib.suppress(ProcessLookupError, PermissionError):
                os.killpg(self._process.pid, signal.SIGKILL)

    def wait(self) -> int | None:
        if self._process.stdin is not None:
            with contextlib.suppress(OSError):
                self._process.stdin.close()
        self._on_end(self)
        with contextlib.suppress(subprocess.TimeoutExpired):
            return self._process.wait(timeout=_END_SECONDS)
        return None


def new_launcher() -> Launcher:
    """The quickest launcher that works here; whoever asks closes it."""
    return WarmLauncher() if HAS_FORK else SpawnLauncher()


@functools.cache
def default_launcher() -> Launcher:
    """The quickest launcher that works here; it lasts as long as this process."""
    launcher = new_launcher()
    atexit.register(launcher.close)
    return launcher
