"""Graph side: when a script gets a turn: at the time for which it asked, and when something came for it."""

from __future__ import annotations

from collections.abc import Callable

from simkit.graph.executor import Executor, ScheduledEvent
from simkit.graph.process.protocol import NEVER

MILLISECOND = 1_000_000
TURNS_PER_INSTANT = 1000
"""After so many turns at one instant a node waits a millisecond: two nodes that answer each other must not stop the clock."""
PATIENCE_NS = 200_000_000
"""What a node only stores waits for its next turn, if that comes within this time [ns]."""


class Turns:
    """The turns of one node, on the clock of its graph.

    Args:
        executor: Owner of the clock.
        act: Lets the node act; it calls `begin` first.
        has_input: Whether something has come for the node since its last turn.
    """

    def __init__(
        self, executor: Executor, act: Callable[[], None], has_input: Callable[[], bool]
    ) -> None:
        self._executor = executor
        self._act = act
        self._has_input = has_input
        self._at_wake: ScheduledEvent | None = None
        self._soon: ScheduledEvent | None = None
        self._instant_ns = -1
        self._count = 0

    def begin(self) -> None:
        """A turn begins: nothing that was planned is to come any more."""
        self.cancel()
        now = self._executor.now_ns
        self._count = self._count + 1 if now == self._instant_ns else 1
        self._instant_ns = now

    def cancel(self) -> None:
        """Take back what was planned."""
        for event in (self._at_wake, self._soon):
            if event is not None:
                event.cancel()
        self._at_wake = self._soon = None

    def soon(self) -> None:
        """Plan a turn at this instant."""
        if self._soon is None:
            now = self._executor.now_ns
            late = MILLISECOND if self._instant_ns == now and self._is_used_up else 0
            self._soon = self._executor.call_at(now + late, self._act)

    def before_long(self) -> None:
        """Plan a turn at this instant, unless one is due within `PATIENCE_NS`."""
        latest = self._executor.now_ns + PATIENCE_NS
        if self._at_wake is None or self._at_wake.time_ns > latest:
            self.soon()

    def sleep(self, wake_ns: int, period_ns: int, end_ns: int) -> None:
        """Plan the turn that a node has asked for when it fell asleep.

        Args:
            wake_ns: When [ns of virtual time], or `NEVER`.
            period_ns: If nothing has come by then, it would look again so much later [ns]; 0 if it wants a turn anyway.
            end_ns: When it stops looking [ns].
        """
        if wake_ns == NEVER:
            return
        now = self._executor.now_ns
        if wake_ns <= now and self._is_used_up:
            wake_ns = now + MILLISECOND

        def look() -> None:
            here = self._executor.now_ns
            if here >= end_ns or self._has_input():
                self._act()
            else:  # it would find what it found before
                self._at_wake = self._executor.call_at(here + period_ns, look)

        self._at_wake = self._executor.call_at(wake_ns, look if period_ns else self._act)

    @property
    def _is_used_up(self) -> bool:
        return self._count >= TURNS_PER_INSTANT
