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


LOOK_EVERY_NS = 1_000_000
"""How often a run that waits for something looks whether it is there, while something moves [ns]."""


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
        self._mover: Callable[[int], None] | None = None
        self._has_begun = False

    @property
    def now_ns(self) -> int:
        """Virtual time [ns]."""
        return self._now_ns

    def begin_at(self, time_ns: int) -> bool:
        """Set the clock [ns] while nothing has happened and nothing waits; False if something has."""
        if self._sequence or self._has_begun:
            return False
        self._now_ns = time_ns
        return True

    def attach(self, mover: Callable[[int], None] | None) -> None:
        """Let something move as time passes, between the events.

        Args:
            mover: Given the time [ns] of the next event, it moves until then and says by `pass_time` how far it
                came; it stops before as soon as `has_due`, since it made an event. None: nothing moves.
        """
        self._mover = mover

    def pass_time(self, time_ns: int) -> None:
        """The mover has come so far [ns]."""
        self._now_ns = time_ns

    def has_due(self) -> bool:
        """Whether an event is due now."""
        due = self.next_time_ns()
        return due is not None and due <= self._now_ns

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
        due = self.next_time_ns()
        if due is None:
            return False
        while not self._move_to(due):
            due = min(due, self.next_time_ns() or due)
        self._run_first()
        return True

    def run_to(self, end_ns: int, stop: Callable[[], bool] | None = None) -> bool:
        """Run every event up to and including `end_ns`, then set the clock to it.

        Args:
            end_ns: Virtual time to reach [ns].
            stop: Asked before the first event, after each, and each millisecond while something moves; True ends
                the run at that instant.

        Returns:
            True if `stop` ended the run.

        Raises:
            GraphError: The loop is already running (a callback called `run`).
        """
        if self._running:
            raise GraphError("the simulation is already running: a callback cannot run it again")
        self._running = True
        try:
            return self._run_to(end_ns, stop)
        finally:
            self._running = False

    def _run_to(self, end_ns: int, stop: Callable[[], bool] | None) -> bool:
        if stop is not None and stop():
            return True
        while True:
            due = self.next_time_ns()
            is_event = due is not None and due <= end_ns
            target = due if is_event and due is not None else end_ns
            if stop is not None and self._mover is not None:
                target = min(target, self._now_ns + LOOK_EVERY_NS)
            has_arrived = self._move_to(target)
            if has_arrived and is_event and target == due:
                self._run_first()
            elif has_arrived and target >= end_ns and not self._is_left(end_ns):
                return stop is not None and self._mover is not None and stop()
            if stop is not None and stop():
                return True

    def _is_left(self, end_ns: int) -> bool:
        """Whether an event waits that belongs before an end; the last step may have made one."""
        due = self.next_time_ns()
        return due is not None and due <= end_ns

    def _run_first(self) -> None:
        event = heapq.heappop(self._events)
        callback, event.callback = event.callback, None
        assert callback is not None  # next_time_ns dropped the cancelled ones
        callback()

    def _move_to(self, time_ns: int) -> bool:
        """Let time pass; False if something came up on the way, and must be done first."""
        self._has_begun = self._has_begun or time_ns > self._now_ns
        if self._mover is not None and time_ns > self._now_ns:
            self._mover(time_ns)
            if self.has_due() and self._now_ns < time_ns:
                return False
        self._now_ns = max(time_ns, self._now_ns)
        return True
