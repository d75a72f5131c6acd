"""How much of a processor a node has had, as Linux tells it."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

_STATE, _UTIME, _STIME = 0, 11, 12
"""Where these stand in a `stat` file, behind the name of the program."""


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
