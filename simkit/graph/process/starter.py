"""What every way to start a node process has in common."""

from __future__ import annotations

import os
import signal
import socket
import sys
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

from simkit.errors import SimkitError
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.usage import Usage

START_TIMEOUT = 30.0
"""Wall time within which a started process must answer [s]."""


class StartError(SimkitError):
    """A node process, or the warm parent of node processes, cannot be started."""


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
