"""Runs a simulation of its own for a person: at the pace of the wall clock, or as fast as the machine can; and Ctrl-C.

Ctrl-C and its kin are something to ask for: an event of the simulation is never cut in two.

Source: roslaunch ends its nodes in order after Ctrl-C (SIGINT) and after `kill` (SIGTERM). A terminal that is closed sends
SIGHUP.
"""

from __future__ import annotations

import contextlib
import math
import signal
import time
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Literal

from simkit.simulation import Simulation

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
SLICE = 0.02
"""Virtual time that passes between two looks at the wall clock [s]."""
End = Literal["over", "interrupted", "idle"]
"""What ended a run."""


def run_for_a_person(
    sim: Simulation, is_over: Callable[[], bool], *, seconds: float | None, fast: bool
) -> End:
    """Let virtual time pass until `is_over()`, or Ctrl-C, or the end of the time.

    Args:
        sim: What runs.
        is_over: Asked after each event.
        seconds: Virtual time to run at most [s]; None for no bound.
        fast: Whether to run as fast as the machine can instead of at the pace of the wall clock.

    Returns:
        What ended it; `idle` if nothing can ever happen again.
    """
    interrupt = Interrupt()

    def stop() -> bool:
        return interrupt.came or is_over()

    idle = False
    with interrupt.caught():
        if not fast:
            _run_paced(sim, stop, math.inf if seconds is None else seconds, interrupt)
        elif seconds is None:
            idle = _run_out(sim, stop)
        else:
            sim.run_until(stop, timeout=seconds)
    if interrupt.came:
        return "interrupted"
    return "idle" if idle else "over"


def _run_out(sim: Simulation, stop: Callable[[], bool]) -> bool:
    """Run every event there is; whether none was left before `stop()` held."""
    while not stop():
        if not sim.step():
            return True
    return False


def _run_paced(
    sim: Simulation, stop: Callable[[], bool], seconds: float, interrupt: Interrupt
) -> None:
    start, begin = sim.now, time.monotonic()
    sim.run_until(stop, timeout=0.0)
    while not stop():
        passed = (sim.now - start).to_sec()
        left = seconds - passed
        if left < 1e-9:
            return
        while not interrupt.came and (early := begin + passed - time.monotonic()) > 0:
            time.sleep(min(early, 0.1))
        sim.run_until(stop, timeout=min(SLICE, left))


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
