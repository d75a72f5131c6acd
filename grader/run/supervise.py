"""Watch one checker process from outside: read what it tells, hold it to its time."""

from __future__ import annotations

import queue
import threading
import time
from dataclasses import dataclass
from io import BufferedReader
from typing import Protocol

from grader.errors import ResultError
from grader.run.events import MAX_LINE, Transcript

MAX_OUTPUT = 20_000
"""How much of a checker's own output is kept, for our errors [bytes]."""


class Checker(Protocol):
    """A checker process that has just been started."""

    results: BufferedReader
    """Where its events arrive."""
    output: BufferedReader
    """What it prints; nothing is decided by it."""

    def kill(self) -> None:
        """End it, and every process that came from it; harmless if it has ended."""

    def wait(self) -> int | None:
        """Its exit code when it has ended; negative for a signal, None if unknown."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TimeLimits:
    """Wall-clock limits, held from outside."""

    check: float = 20.0
    """For one check [s]."""
    exercise: float = 60.0
    """For all the checks of an exercise, and the start of the process [s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """How a checker process ended."""

    transcript: Transcript
    exit_code: int | None
    """Negative for a signal; None if unknown."""
    output: str
    """The beginning of what it printed."""
    overrun: float | None = None
    """The limit that it ran into [s]; None if it ended by itself."""
    fault: str = ""
    """What was wrong with its events; empty if nothing."""


def supervise(checker: Checker, limits: TimeLimits) -> Outcome:
    """Follow a checker until it ends or its time is over; nothing of it is alive afterwards."""
    lines: queue.Queue[bytes | None] = queue.Queue()
    output = bytearray()
    threads = [
        threading.Thread(target=_read_lines, args=(checker.results, lines), daemon=True),
        threading.Thread(target=_drain, args=(checker.output, output), daemon=True),
    ]
    for thread in threads:
        thread.start()
    transcript = Transcript()
    overrun, fault = None, ""
    try:
        overrun = _follow(transcript, lines, limits)
    except ResultError as error:
        fault = str(error)
    finally:
        checker.kill()
        exit_code = checker.wait()
        for thread in threads:
            thread.join(timeout=5.0)
    text = bytes(output).decode("utf-8", "replace")
    return Outcome(
        transcript=transcript, exit_code=exit_code, output=text, overrun=overrun, fault=fault
    )


def _follow(
    transcript: Transcript, lines: queue.Queue[bytes | None], limits: TimeLimits
) -> float | None:
    """Take events until the last one; the limit that was overrun, or None."""
    end = time.monotonic() + limits.exercise
    check_end = end
    while not transcript.ended:
        try:
            line = lines.get(timeout=max(0.0, min(end, check_end) - time.monotonic()))
        except queue.Empty:
            return limits.check if check_end < end else limits.exercise
        if line is None:
            return None
        running = transcript.running
        transcript.add(line)
        if transcript.running != running:
            has_begun = transcript.running is not None
            check_end = time.monotonic() + limits.check if has_begun else end
    return None


def _read_lines(stream: BufferedReader, lines: queue.Queue[bytes | None]) -> None:
    with stream:
        while line := stream.readline(MAX_LINE):
            lines.put(line)
    lines.put(None)


def _drain(stream: BufferedReader, output: bytearray) -> None:
    with stream:
        while piece := stream.read1(65536):
            output += piece[: max(0, MAX_OUTPUT - len(output))]
