"""Sleeping, rates and timers on virtual time."""

from __future__ import annotations

from collections.abc import Callable

import simkit.msgs
from simkit.graph.process import client

from .core import interrupted, require_init
from .rostime import Duration, get_rostime


def sleep(duration: float | simkit.msgs.Duration) -> None:
    """Block for a time [s]; negative durations return at once.

    Raises:
        ROSInterruptException: The node is shut down.
    """
    require_init("rospy.sleep")
    nanoseconds = (
        duration.to_nsec() if isinstance(duration, simkit.msgs.Duration) else round(duration * 1e9)
    )
    line = client.current()
    if nanoseconds >= 0:
        line.sleep_until(line.peek_ns() + nanoseconds)
    if line.shutdown_reason is not None:
        raise interrupted("ROS shutdown request")


class Rate:
    """Keeps a loop at a frequency [Hz].

    Args:
        hz: Turns per second of virtual time.
        reset: Start anew when time jumps back.
    """

    def __init__(self, hz: float, reset: bool = False) -> None:
        self.last_time: simkit.msgs.Time = get_rostime()
        self.sleep_dur = Duration(0, int(1e9 / hz))
        self._reset = reset

    def remaining(self) -> simkit.msgs.Duration:
        """What is left of this turn."""
        return self._remaining(get_rostime())

    def sleep(self) -> None:
        """Block until the turn is over.

        Raises:
            ROSInterruptException: The node is shut down.
        """
        now = get_rostime()
        sleep(self._remaining(now))
        self.last_time = self.last_time + self.sleep_dur
        # A loop that fell behind by two turns starts anew instead of catching up in a burst.
        if now - self.last_time > self.sleep_dur * 2:
            self.last_time = now

    def _remaining(self, now: simkit.msgs.Time) -> simkit.msgs.Duration:
        if self.last_time > now:
            self.last_time = now
        elapsed = now - self.last_time
        return self.sleep_dur - elapsed


class _Beat:
    """The beat of a timer: late turns come at once, but who is late by more than two begins anew."""

    def __init__(self, period_ns: int) -> None:
        self._line = client.current()
        self._period_ns = period_ns
        self._last_ns = self._line.peek_ns()

    def wait(self) -> None:
        now = self._line.peek_ns()
        self._last_ns += self._period_ns
        if self._last_ns > now:
            self._line.sleep_until(self._last_ns)
        elif now - self._last_ns > 2 * self._period_ns:
            self._last_ns = now


class TimerEvent:
    """What a timer gives its callback."""

    def __init__(
        self,
        last_expected: simkit.msgs.Time | None,
        last_real: simkit.msgs.Time | None,
        current_expected: simkit.msgs.Time,
        current_real: simkit.msgs.Time,
        last_duration: float | None,
    ) -> None:
        self.last_expected = last_expected
        self.last_real = last_real
        self.current_expected = current_expected
        self.current_real = current_real
        self.last_duration = last_duration


class Timer:
    """Calls back at a period, in a thread of its own.

    Args:
        period: Virtual time between calls.
        callback: Takes a `TimerEvent`.
        oneshot: Call once only.
        reset: Start anew when time jumps back.
    """

    def __init__(
        self,
        period: simkit.msgs.Duration,
        callback: Callable[[TimerEvent], object],
        oneshot: bool = False,
        reset: bool = False,
    ) -> None:
        require_init("rospy.Timer")
        self._period = period
        self._callback = callback
        self._oneshot = oneshot
        self._shutdown = False
        self._reset = reset
        if not isinstance(period, simkit.msgs.Duration):
            raise TypeError(f"a Timer's period is a rospy.Duration, not {period!r}")
        if period.to_nsec() <= 0:
            raise ValueError(f"a Timer's period must be longer than {period.to_sec():g} s")
        self._task = client.current().scheduler.start(self._run, "timer")

    def shutdown(self) -> None:
        """Call back no more."""
        self._shutdown = True

    def is_alive(self) -> bool:
        """Whether it may still call back."""
        return not self._task.done

    def join(self, timeout: float | None = None) -> None:
        """Block until it has ended, or for a time [s]."""
        line = client.current()
        until = None if timeout is None else line.peek_ns() + round(timeout * 1e9)
        line.scheduler.join(self._task, until)

    def _run(self) -> None:
        line, beat = client.current(), _Beat(self._period.to_nsec())
        expected = get_rostime() + self._period
        last_expected: simkit.msgs.Time | None = None
        last_real: simkit.msgs.Time | None = None
        duration: float | None = None
        while not self._shutdown:
            beat.wait()
            if self._shutdown or line.shutdown_reason is not None:
                return
            real = get_rostime()
            self._call(TimerEvent(last_expected, last_real, expected, real, duration))
            if self._oneshot:
                return
            duration = (get_rostime() - real).to_sec()
            last_expected, last_real = expected, real
            expected = expected + self._period

    def _call(self, event: TimerEvent) -> None:
        from .logs import report_bad_callback

        try:
            self._callback(event)
        except Exception as error:
            report_bad_callback(self._callback, error)
            self._shutdown = True  # as in rospy: the timer's thread has died
