"""A fork server: a Python that has imported what its children need, and forks each in a few milliseconds.

One end starts the server and sends it requests, with file descriptors, over a socket. When that socket closes, whatever
the reason, the server ends. There is one server for nodes (`zygote`) and one for the checkers of the grader.
"""

from __future__ import annotations

import contextlib
import gc
import math
import os
import select
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence

from simkit.errors import SimkitError

START_TIMEOUT = 30.0
"""Wall time within which a started process must answer [s]."""
END_TIMEOUT = 10.0
"""Wall time within which a server must end once its socket is closed [s]."""
MOST_FDS = 3
"""Most file descriptors beside one request."""
HAS_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds") and sys.platform != "darwin"
"""macOS can fork, but its system libraries do not survive it: a fresh interpreter is right there."""

Source = socket.socket | int
"""What can be waited for: a socket, or (not on Windows) any file descriptor."""


class StartError(SimkitError):
    """A process of ours, or the fork server that makes them, cannot be started."""


class ForkServer:
    """The end that asks.

    Args:
        module: Module to run; its argument is the file descriptor of its end of the socket.
        environment: Environment of the server and its children.
        command_prefix: Put before the command, such as that of bubblewrap.
        purpose: Whose parent it is, for messages: `node processes`.
        stderr: Where the server's errors go: kept for `StartError`, or, if None, to our own.
    """

    def __init__(
        self,
        module: str,
        *,
        environment: Mapping[str, str],
        command_prefix: Sequence[str] = (),
        purpose: str,
        stderr: int | None = subprocess.PIPE,
    ) -> None:
        self._purpose = purpose
        self._control, theirs = socket.socketpair()
        self._control.settimeout(START_TIMEOUT)
        with theirs:
            command = [*command_prefix, *python_command(module, str(theirs.fileno()))]
            try:
                self._process = subprocess.Popen(
                    command,
                    stdin=subprocess.DEVNULL,
                    stdout=subprocess.DEVNULL,
                    stderr=stderr,
                    env=dict(environment),
                    pass_fds=[theirs.fileno()],
                    start_new_session=True,
                )
            except OSError as error:
                self._control.close()
                raise StartError(f"cannot start {command[0]}: {error.strerror}") from error
        self._pending = b""

    @property
    def pid(self) -> int:
        """Process id of the server."""
        return self._process.pid

    @property
    def alive(self) -> bool:
        """Whether the server runs."""
        return self._process.poll() is None

    def send(self, request: bytes, fds: Sequence[int] = ()) -> None:
        """Send a request.

        Raises:
            StartError: The server is gone.
        """
        try:
            socket.send_fds(self._control, [request], list(fds))
        except OSError as error:
            raise StartError(self._epitaph()) from error

    def read_line(self) -> bytes:
        """The next line of its answers.

        Raises:
            StartError: The server is gone.
        """
        while b"\n" not in self._pending:
            try:
                data = self._control.recv(65536)
            except OSError as error:
                raise StartError(self._epitaph()) from error
            if not data:
                raise StartError(self._epitaph())
            self._pending += data
        line, _, self._pending = self._pending.partition(b"\n")
        return line

    def close(self) -> None:
        """Close the socket, at which the server ends what it started, and itself."""
        self._control.close()
        try:
            self._process.wait(timeout=END_TIMEOUT)
        except subprocess.TimeoutExpired:
            self._kill()
        if self._process.stderr is not None:
            self._process.stderr.close()

    def _kill(self) -> None:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def _epitaph(self) -> str:
        """Why the server is gone, from what it said last."""
        self._kill()
        said = ""
        if self._process.stderr is not None and not self._process.stderr.closed:
            fd = self._process.stderr.fileno()
            if readable([fd], 0.5):
                said = os.read(fd, 4000).decode(errors="replace")
        last = said.strip().splitlines()[-1:] or ["no word"]
        return f"the parent of the {self._purpose} has died (exit code {self._process.returncode}): {last[0]}"


# -- the end that serves


def each_request(control: socket.socket) -> Iterator[tuple[bytes, list[int]]]:
    """Each request and its file descriptors, until the other end closes; whoever takes them closes them."""
    while True:
        message, fds, _, _ = socket.recv_fds(control, 1 << 20, MOST_FDS)
        if not message:
            return
        yield message, fds


def fork_task(task: Callable[..., None], *arguments: object) -> int:
    """Run a task as the whole life of a forked child; its process id."""
    pid = os.fork()
    if pid:
        return pid
    code = 70
    try:
        task(*arguments)
        code = 0
    except BaseException as error:
        with contextlib.suppress(OSError):
            os.write(2, f"{type(error).__name__}: {error}\n".encode("utf-8", "replace"))
    finally:
        os._exit(code)


def share_memory() -> None:
    """Let children share the pages that are there, instead of copying them at the first collection."""
    gc.collect()
    gc.freeze()


# -- what every process of ours has in common


def clean_environment(extra: Mapping[str, str]) -> dict[str, str]:
    """The environment of our processes: the same on every machine, and no secret in it."""
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


def readable(sources: Sequence[Source], timeout: float) -> list[Source]:
    """Those of `sources` that can be read or have ended, after at most `timeout` [s]."""
    if not hasattr(select, "poll"):
        return list(select.select(sources, [], [], timeout)[0])
    # `select` cannot take descriptors beyond 1023, which a class of simulations in one process reaches.
    poll = select.poll()
    by_fd = {source if isinstance(source, int) else source.fileno(): source for source in sources}
    for fd in by_fd:
        poll.register(fd, select.POLLIN)
    return [by_fd[fd] for fd, _ in poll.poll(math.ceil(timeout * 1000))]
