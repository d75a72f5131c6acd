"""rospy's Time and Duration: those of genpy, with `now`."""

from __future__ import annotations

from typing import Any

import simkit.msgs
from simkit.graph.process import client

from .core import is_initialized
from .exceptions import ROSInitException


class Duration(simkit.msgs.Duration):
    """A span of time."""

    __slots__ = ()

    def __repr__(self) -> str:
        return f"rospy.Duration[{self.to_nsec()}]"


class Time(simkit.msgs.Time):
    """A point of virtual time; `Time(0)` asks tf for the latest."""

    __slots__ = ()

    def __repr__(self) -> str:
        return f"rospy.Time[{self.to_nsec()}]"

    @classmethod
    def now(cls) -> Time:
        """The present.

        Raises:
            ROSInitException: `init_node` has not been called.
        """
        return get_rostime()

    @classmethod
    def from_seconds(cls, secs: float) -> Any:
        """As `from_sec`."""
        return cls.from_sec(secs)


def get_rostime() -> Time:
    """The present.

    Raises:
        ROSInitException: `init_node` has not been called.
    """
    if not is_initialized():
        raise ROSInitException("time is not initialized. Have you called init_node()?")
    return Time.from_nsec(client.current().now_ns())


def get_time() -> float:
    """The present [s]."""
    return get_rostime().to_sec()


def is_rostime_initialized() -> bool:
    """Whether time can be read."""
    return is_initialized()


def is_wallclock() -> bool:
    """False: time is virtual."""
    return False
