"""What a controller is: something that reads joints and commands them, step by step."""

from __future__ import annotations

import enum

from simkit.msgs import Time
from simkit.plugins.control.place import ControllerPlace


class ControllerState(enum.Enum):
    """What a controller does."""

    INITIALIZED = "initialized"
    """It is loaded, and has not worked yet."""
    RUNNING = "running"
    """It works."""
    STOPPED = "stopped"
    """It has worked, and does not now."""


class Controller:
    """One controller; a subclass takes its joints and topics when it is made, and overrides the rest.

    Times are virtual times [ns]. An update prepares the step that ends at its time.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It cannot work so.
    """

    def __init__(self, place: ControllerPlace) -> None:
        self.place = place
        self.state = ControllerState.INITIALIZED
        self.claims: tuple[str, ...] = ()
        """Names of the joints that it needs for itself while it runs."""

    @property
    def is_running(self) -> bool:
        """Whether it works."""
        return self.state is ControllerState.RUNNING

    def starting(self, time_ns: int) -> None:
        """It begins to work."""

    def update(self, time_ns: int, period_ns: int) -> None:
        """Command the joints; so much time has passed since the last update."""

    def is_due(self, time_ns: int) -> bool:  # noqa: ARG002 - for those that override it
        """Whether it has something to say after a step; asked once a step."""
        return False

    def publish(self, time_ns: int) -> None:
        """The step is made, it is due, and the joints were read again: say how things stand."""

    def stopping(self, time_ns: int) -> None:
        """It ceases to work."""


class Due:
    """Whether a message is due that is published so many times a second.

    Args:
        hertz: Times a second; 0 or less: never.

    Source:
        `publishState` of ros_controllers: `if (last + period < time) last += period`.
    """

    def __init__(self, hertz: float) -> None:
        self._period_ns = round(1e9 / hertz) if hertz > 0.0 else 0
        self._last_ns = 0

    def begin(self, time_ns: int) -> None:
        """The first one is due a period after this time [ns]."""
        self._last_ns = time_ns

    def at(self, time_ns: int) -> bool:
        """Whether one is due; asked once a step."""
        if not self._period_ns or self._last_ns + self._period_ns >= time_ns:
            return False
        self._last_ns += self._period_ns
        return True


def stamp(time_ns: int) -> Time:
    """A time as messages have it."""
    return Time.from_nsec(time_ns)
