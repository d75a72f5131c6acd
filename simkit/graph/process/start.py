"""How a node process comes into being: forked from a warm parent, or, where there is no fork, as a fresh interpreter.

Both give a `StartedProcess`; nothing else in simkit knows the difference.
"""

from __future__ import annotations

import os
import socket
import sys
from collections.abc import Mapping, Sequence

from simkit.graph.process.fork_starter import ForkStarter
from simkit.graph.process.spawn_starter import SpawnStarter
from simkit.graph.process.starter import StartedProcess, Starter, StartError

__all__ = ["HAS_FORK", "StartError", "StartedProcess", "Starter", "default_starter"]

HAS_FORK = hasattr(os, "fork") and hasattr(socket, "send_fds") and sys.platform != "darwin"
"""macOS can fork, but its system libraries do not survive it: a fresh interpreter is right there."""


def default_starter(
    command_prefix: Sequence[str], environment: Mapping[str, str], method: str | None = None
) -> Starter:
    """The quickest starter that works here: `fork` on Linux, `spawn` elsewhere, or the one asked for."""
    method = method or ("fork" if HAS_FORK else "spawn")
    kind = {"fork": ForkStarter, "spawn": SpawnStarter}[method]
    return kind(command_prefix, environment)
