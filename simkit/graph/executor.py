"""Virtual time: a discrete-event loop on integer nanoseconds.

Everything that happens in a simulation is an event with a time and a sequence number; events run in the order of that pair.
Nothing here looks at the wall clock, so the same events run in the same order on every machine.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable

from simkit.graph.errors import GraphError


def nanoseconds(seconds: float) -> int:
    """A span of virtual time [s] in nanoseconds.

    Raises:
        GraphError: It is negative, or not finite.
    """
    if not math.isfinite(seconds) or seconds < 0:
        raise GraphError(f"a time of {seconds} s cannot pass: give a number of seconds, 0 or more")
    return round(seconds * 1e9)


class ScheduledEvent:
    """A callback that waits for its time; `cancel()` takes it back."""

    __slots__ = ("callback", "sequence", "time_ns")

    def __init__(self, time_ns: int, sequence: int, callback: Callable[[], None]) -> None:
        self.time_ns = time_ns
        self.sequence = sequence
        self.callback: Callable[[], None] | None = callback

    def __lt__(self, other: ScheduledEvent) -> bool:
        return (self.time_ns, self.sequence) < (other.time_ns, other.sequence)

    def cancel(self) -> None:
        """Never run this event; harmless when it has run."""
        self.callback = None


class Executor:
    """Runs events in the order of (time, sequence number) and owns the clock.

    Args:
        start_ns: Virtual time at the beginning [ns].
    """

    def __init__(self, start_ns: int = 0) -> None:
        self._now_ns = start_ns
        self._sequence = 0
        self._events: list[ScheduledEvent] = []
        self._running = False

    @property
    def now_ns(self) -> int:
        """Virtual time [ns]."""
        return self._now_ns

    def call_at(self, time_ns: int, callback: Callable[[], None]) -> ScheduledEvent:
        """Run `callback` at a virtual time [ns]; at once (after what is due already) if it is past."""
        self._sequence += 1
        event = ScheduledEvent(max(time_ns, self._now_ns), self._sequence, callback)
        heapq.heappush(self._events, event)
        return event

    def call_soon(self, callback: Callable[[], None]) -> ScheduledEvent:
        """Run `callback` at this instant, after the events that are due already."""
        return self.call_at(self._now_ns, callback)

    def next_time_ns(self) -> int | None:
        """Time of the next event [ns], or None when nothing is scheduled."""
        while self._events and self._events[0].callback is None:
            heapq.heappop(self._events)
        return self._events[0].time_ns if self._events else None

    def step(self) -> bool:
        """Move to the next event and run it; False when there is none."""
        if self.next_time_ns() is None:
            return False
        event = heapq.heappop(self._events)
        callback, event.callback = event.callback, None
        self._move_clock(event.time_ns)
        assert callback is not None  # next_time_ns dropped the cancelled ones
        callback()
        return True

    def run_to(self, end_ns: int, stop: Callable[[], bool] | None = None) -> bool:
        """Run every event up to and including `end_ns`, then set the clock to it.

        Args:
            end_ns: Virtual time to reach [ns].
            stop: Asked before the first and after each event; True ends the run at that instant.

        Returns:
            True if `stop` ended the run.

        Raises:
            GraphError: The loop is already running (a callback called `run`).
        """
        if self._running:
            raise GraphError("the simulation is already running: a callback cannot run it again")
        self._running = True
        try:
            if stop is not None and stop():
                return True
            while (due := self.next_time_ns()) is not None and due <= end_ns:
                self.step()
                if stop is not None and stop():
                    return True
            self._move_clock(max(end_ns, self._now_ns))
            return False
        finally:
            self._running = False

    def _move_clock(self, time_ns: int) -> None:
        # The one place where time passes: a physics world will be stepped here, up to the next event.
        self._now_ns = time_ns
