"""Find and end every process that came from this one; Linux tells of them, other systems do not."""

from __future__ import annotations

import contextlib
import os
import signal
import time
from pathlib import Path

_ROUNDS = 100
_SECONDS = 5.0


def end_family(child: int) -> int | None:
    """Kill a child process with everything that came from it, and reap what has come to us.

    They are stopped first, all of them, so that none starts another while we look: a fork bomb
    is faster than a loop that kills.

    Returns:
        The child's exit code, negative for a signal; None if it cannot be had.
    """
    family = {child}
    for _ in range(_ROUNDS):
        _send(family, signal.SIGSTOP)
        grown = family | set(descendants(os.getpid()))
        if grown == family:
            break
        family = grown
    _send(family, signal.SIGKILL)
    return _reap(child)


def _reap(child: int) -> int | None:
    exit_code = None
    deadline = time.monotonic() + _SECONDS
    while time.monotonic() < deadline:
        try:
            pid, status = os.waitpid(-1, os.WNOHANG)
        except ChildProcessError:
            break
        if pid == child:
            exit_code = os.waitstatus_to_exitcode(status)
        elif pid == 0:
            _send(set(descendants(os.getpid())), signal.SIGKILL)
            time.sleep(0.0005)
    return exit_code


def descendants(pid: int) -> list[int]:
    """Process ids of the children of a process, their children, and so on; empty if unknown."""
    found: list[int] = []
    to_visit = [pid]
    while to_visit:
        children = _children(to_visit.pop())
        found += children
        to_visit += children
    return found


def _children(pid: int) -> list[int]:
    found: list[int] = []
    with contextlib.suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            found += [int(child) for child in (task / "children").read_text().split()]
    return found


def _send(pids: set[int], number: int) -> None:
    for pid in pids:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(pid, number)
