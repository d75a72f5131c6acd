"""What every way to start a node process has in common."""

from __future__ import annotations

import signal
import socket
from abc import ABC, abstractmethod
from dataclasses import dataclass

from simkit.graph.process.process_tree import Usage
from simkit.graph.process.spec import StartSpec


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
