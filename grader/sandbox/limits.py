"""How much of the machine one node of a student may use."""

from __future__ import annotations

import contextlib
import os
import sys
from pathlib import Path

from simkit.graph.process import NodeLimits

MIB = 1024 * 1024

CPU_SECONDS = 20
"""Processor time of one node [s]; a check's own limit of wall time ends most loops before."""
MEMORY_BYTES = 1024 * MIB
"""Address space of one node [bytes]; numpy alone takes 0.25 GiB."""
PROCESSES = 64
"""Processes and threads of one node's user."""
OPEN_FILES = 128
"""Open file descriptors of one node."""
FILE_BYTES = 16 * MIB
"""Longest file a node may write [bytes]."""
OUTPUT_BYTES = 1 * MIB
"""What one node may print [bytes]."""
TEMPORARY_BYTES = 64 * MIB
"""Size of the private /tmp [bytes]; it lies in memory."""


def node_limits(*, own_user: bool) -> NodeLimits:
    """Limits of a student's node.

    Args:
        own_user: Whether nodes have a user, or a user namespace, of their own. The kernel counts
            processes by user: without one, those of whoever grades are counted too.
    """
    return NodeLimits(
        cpu_seconds=CPU_SECONDS,
        memory_bytes=MEMORY_BYTES,
        processes=PROCESSES if own_user else _processes_of_user(),
        open_files=OPEN_FILES,
        file_bytes=FILE_BYTES,
        output_bytes=OUTPUT_BYTES,
    )


def _processes_of_user() -> int | None:
    """Room for a node beside the tasks that our user has now; None where nobody tells how many."""
    if sys.platform != "linux":
        return None
    tasks = 0
    for folder in Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if folder.name.isdigit() and folder.stat().st_uid == os.getuid():
                tasks += len(list((folder / "task").iterdir()))
    return tasks + 4 * PROCESSES


def node_environment(home: str) -> dict[str, str]:
    """What a student's node gets on top of the clean environment that simkit gives to every node.

    Args:
        home: A folder that the node may write to.
    """
    return {"HOME": home, "TMPDIR": home}
