"""Ctrl-C, as something to ask for: an event of the simulation is never cut in two."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from types import FrameType


class Interrupt:
    """Remembers that Ctrl-C was pressed; a second time ends everything at once."""

    def __init__(self) -> None:
        self.came = False

    @contextlib.contextmanager
    def caught(self) -> Iterator[None]:
        """Catch Ctrl-C while the body runs."""
        before = signal.signal(signal.SIGINT, self._catch)
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, before)

    def _catch(self, _number: int, _frame: FrameType | None) -> None:
        if self.came:
            raise KeyboardInterrupt
        self.came = True
