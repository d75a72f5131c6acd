"""When a plugin that works so many times a second is due."""

from __future__ import annotations


class UpdateRate:
    """Due whenever more than a period has passed since it was due last, in steps of a period.

    With steps of 1 ms and 20 Hz that is at .051, .101, .151 s after it was made; at a rate of 0 each time.

    Args:
        hertz: Times a second.
        now_ns: Time at which it is made [ns].

    Source:
        `gazebo_ros_diff_drive` and its relatives: `if (elapsed > period) last += period`.
    """

    def __init__(self, hertz: float, now_ns: int) -> None:
        self.period_ns = round(1e9 / hertz) if hertz > 0.0 else 0
        self._last_ns = now_ns
        self.elapsed_ns = 0
        """Time that it takes to have passed when it is due: a period, and what is over [ns]."""

    @property
    def due_ns(self) -> int:
        """Time from which on it is due [ns]."""
        return self._last_ns + self.period_ns + 1 if self.period_ns else 0

    def is_due(self, now_ns: int) -> bool:
        """Whether it is due; asked once a step."""
        if now_ns < self.due_ns:
            return False
        self.elapsed_ns = now_ns - self._last_ns
        self._last_ns = self._last_ns + self.period_ns if self.period_ns else now_ns
        return True


class SensorRate:
    """Due when a period has passed; what it was late counts for the next time.

    So it keeps its rate also where the period is no whole number of steps: at 30 Hz it is due after
    34, 67, 100, 134 ... steps of 1 ms.

    Args:
        hertz: Times a second; 0: each time that it is asked.
        now_ns: Time at which it is made [ns].

    Source:
        Gazebo's `Sensor::Update`.
    """

    def __init__(self, hertz: float, now_ns: int) -> None:
        self.period_ns = round(1e9 / hertz) if hertz > 0.0 else 0
        self.restart(now_ns)

    def restart(self, now_ns: int) -> None:
        """Begin anew, as when it was made."""
        self._last_ns = now_ns
        self._late_ns = 0

    @property
    def due_ns(self) -> int:
        """Time from which on it is due [ns]."""
        return self._last_ns + self.period_ns - self._late_ns

    def is_due(self, now_ns: int) -> bool:
        """Whether it is due; asked at most once a step, and only while someone wants to know."""
        late_ns = now_ns - self.due_ns
        if late_ns < 0:
            return False
        # After a whole period too much there is nothing to make up for: it slept.
        self._late_ns = late_ns if late_ns < self.period_ns else 0
        self._last_ns = now_ns
        return True
