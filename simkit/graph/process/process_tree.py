"""Processes that came from this one: ask Linux about them, and end them all; other systems do not know them."""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import sys
import time
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from pathlib import Path

_ROUNDS = 100
_SECONDS = 5.0
_PR_SET_PDEATHSIG = 1
_PR_SET_DUMPABLE = 4
_PR_SET_CHILD_SUBREAPER = 36

_STATE, _UTIME, _STIME = 0, 11, 12
"""Where these stand in a `stat` file, behind the name of the program."""


def become_reaper() -> None:
    """Become the parent of whatever detaches itself below this process, so that it is found and ended."""
    _prctl(_PR_SET_CHILD_SUBREAPER, 1)


def hide_memory() -> None:
    """Let no process of the same user look into this one."""
    _prctl(_PR_SET_DUMPABLE, 0)


def end_with_parent() -> None:
    """Die when the parent dies."""
    _prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)


def _prctl(option: int, value: int) -> None:
    if sys.platform == "linux":
        with contextlib.suppress(OSError, AttributeError):
            ctypes.CDLL(None, use_errno=True).prctl(option, value, 0, 0, 0)


def children(pid: int) -> list[int]:
    """Process ids of the children of a process, also of those that wait to be reaped; empty if unknown."""
    found: list[int] = []
    with contextlib.suppress(OSError):
        for task in Path(f"/proc/{pid}/task").iterdir():
            found += [int(child) for child in (task / "children").read_text().split()]
    return found


def descendants(pid: int, *, spare: Collection[int] = ()) -> list[int]:
    """Process ids of the children of a process, their children, and so on; empty if unknown.

    Args:
        pid: The process.
        spare: Leave these out, with what came from them.
    """
    found: list[int] = []
    to_visit = [pid]
    while to_visit:
        below = [child for child in children(to_visit.pop()) if child not in spare]
        found += below
        to_visit += below
    return found


def end_tree(child: int, *, spare: Collection[int] = ()) -> int | None:
    """Kill a child process with everything that came from it, and reap what has come to us.

    They are stopped first, all of them, so that none starts another while we look: a fork bomb
    is faster than a loop that kills.

    Args:
        child: The child.
        spare: Other children of ours, which stay with what came from them.

    Returns:
        The child's exit code, negative for a signal; None if it cannot be had.
    """
    tree = {child}
    for _ in range(_ROUNDS):
        _send(tree, signal.SIGSTOP)
        grown = tree | set(descendants(os.getpid(), spare=spare))
        if grown == tree:
            break
        tree = grown
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(child, signal.SIGKILL)  # where children are not known, its session at least
    _send(tree, signal.SIGKILL)
    return _reap(child, spare)


def end_orphans(*, spare: Collection[int]) -> None:
    """Kill and reap whatever has come to us, but for the children `spare`."""
    for _ in range(_ROUNDS):
        strays = [pid for pid in children(os.getpid()) if pid not in spare]
        if not strays:
            return
        for pid in strays:
            end_tree(pid, spare=spare)


def wait_for(child: int) -> int | None:
    """Reap a child that is about to end; its exit code, None if it does not end or is not ours."""
    deadline = time.monotonic() + _SECONDS
    while time.monotonic() < deadline:
        try:
            done, status = os.waitpid(child, os.WNOHANG)
        except ChildProcessError:
            return None
        if done:
            return os.waitstatus_to_exitcode(status)
        time.sleep(0.0005)
    return None


def _reap(child: int, spare: Collection[int]) -> int | None:
    exit_code = None
    waiting = {child}
    deadline = time.monotonic() + _SECONDS
    while waiting and time.monotonic() < deadline:
        for pid in list(waiting):
            try:
                done, status = os.waitpid(pid, os.WNOHANG)
            except ChildProcessError:
                done, status = pid, -1
            if done:
                waiting.discard(pid)
            if done == child and status >= 0:
                exit_code = os.waitstatus_to_exitcode(status)
        waiting |= {pid for pid in children(os.getpid()) if pid not in spare}
        if waiting:
            _send(descendants(os.getpid(), spare=spare), signal.SIGKILL)
            time.sleep(0.0005)
    return exit_code


def _send(pids: Iterable[int], number: int) -> None:
    for pid in pids:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.kill(pid, number)


@dataclass(frozen=True, slots=True, kw_only=True)
class Usage:
    """What one process has used since it began."""

    cpu_s: float
    """Processor time of all its threads [s]."""
    is_computing: bool
    """Whether one of its threads computes now, or would if a processor were free."""


def usage_of(pid: int) -> Usage | None:
    """What a process has used; None if it is gone, or this is not Linux."""
    folder = Path("/proc") / str(pid)
    try:
        whole = _fields(folder / "stat")
        threads = [_fields(task / "stat") for task in (folder / "task").iterdir()]
        ticks = int(whole[_UTIME]) + int(whole[_STIME])
        cpu_s = ticks / os.sysconf("SC_CLK_TCK")
    except (OSError, ValueError, IndexError, AttributeError):
        return None
    return Usage(cpu_s=cpu_s, is_computing=any(one[_STATE] in "RD" for one in threads))


def _fields(path: Path) -> list[str]:
    # The name of the program, in parentheses, may hold spaces and parentheses itself.
    return path.read_text(errors="replace").rpartition(")")[2].split()
