"""Ctrl-C and its kin, as something to ask for: an event of the simulation is never cut in two.

Source: roslaunch ends its nodes in order after Ctrl-C (SIGINT) and after `kill` (SIGTERM). A terminal that is closed sends
SIGHUP.
"""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from types import FrameType

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]


class Interrupt:
    """Remembers that Ctrl-C was pressed, or that somebody else wants an end; a second time ends everything at once."""

    def __init__(self) -> None:
        self.came = False

    @contextlib.contextmanager
    def caught(self) -> Iterator[None]:
        """Catch Ctrl-C and its kin while the body runs."""
        before = [(one, signal.signal(one, self._catch)) for one in _SIGNALS]
        try:
            yield
        finally:
            for one, handler in before:
                signal.signal(one, handler)

    def _catch(self, _number: int, _frame: FrameType | None) -> None:
        if self.came:
            raise KeyboardInterrupt
        self.came = True
