"""The kernel of a notebook, and work for its main thread, between two cells.

A notebook may handle the messages of its widgets in a thread of their own, while a cell runs. What
runs a simulation waits here until no cell does.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, Protocol


def running_notebook() -> Any:
    """IPython's shell in the kernel of a notebook; None elsewhere."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell if hasattr(shell, "kernel") else None


class Later(Protocol):
    """Where work can wait."""

    def soon(self, work: Callable[[], None]) -> None:
        """Do it when nothing else runs."""

    def after(self, seconds: float, work: Callable[[], None]) -> None:
        """Do it when nothing else runs, but not sooner than so long [s of wall-clock time]."""


class KernelLoop:
    """The event loop of the kernel; without a kernel, work is done at once."""

    def soon(self, work: Callable[[], None]) -> None:
        """Do it when no cell runs."""
        loop = _loop()
        if loop is None:
            work()
        else:
            loop.add_callback(work)

    def after(self, seconds: float, work: Callable[[], None]) -> None:
        """Do it when no cell runs, but not sooner than so long [s]; never without a kernel."""
        loop = _loop()
        if loop is not None:
            loop.add_callback(lambda: loop.call_later(seconds, work))


def _loop() -> Any:
    shell = running_notebook()
    return None if shell is None else getattr(shell.kernel, "io_loop", None)
