"""Node side: every clock and every die that a script can see belongs to the simulation."""

from __future__ import annotations

import datetime as datetime_module
import random
import time
from collections.abc import Callable
from typing import Any

_real_datetime = datetime_module.datetime
_real_date = datetime_module.date
_real_gmtime = time.gmtime


def virtualise_time(read_ns: Callable[[], int], sleep: Callable[[float], None]) -> None:
    """Make `time` and `datetime` of this process tell virtual time.

    Args:
        read_ns: Virtual time since 1970 [ns].
        sleep: Lets virtual time pass [s].
    """

    def seconds() -> float:
        return read_ns() / 1e9

    for name in ("time", "monotonic", "perf_counter", "process_time", "thread_time"):
        setattr(time, name, seconds)
        setattr(time, name + "_ns", read_ns)
    time.clock_gettime = lambda _clock: seconds()
    time.clock_gettime_ns = lambda _clock: read_ns()
    time.sleep = sleep  # type: ignore[assignment]
    time.gmtime = lambda secs=None: _real_gmtime(seconds() if secs is None else secs)
    # Every machine is in UTC, or two of them would print two times.
    time.localtime = lambda secs=None: _real_gmtime(seconds() if secs is None else secs)
    real_strftime, real_ctime = time.strftime, time.ctime
    time.strftime = lambda form, t=None: real_strftime(form, time.localtime() if t is None else t)
    time.ctime = lambda secs=None: real_ctime(seconds() if secs is None else secs)
    _virtualise_datetime(seconds)


def _virtualise_datetime(seconds: Callable[[], float]) -> None:
    class _Meta(type):
        # A datetime that C code made (an addition, a parse) is still a datetime to the script.
        def __instancecheck__(cls, instance: object) -> bool:
            return isinstance(instance, _real_datetime)

    class VirtualDatetime(_real_datetime, metaclass=_Meta):
        @classmethod
        def now(cls, tz: Any = None) -> Any:
            utc = _real_datetime.fromtimestamp(seconds(), datetime_module.UTC)
            return utc.replace(tzinfo=None) if tz is None else utc.astimezone(tz)

        @classmethod
        def utcnow(cls) -> Any:
            return cls.now()

        @classmethod
        def today(cls) -> Any:
            return cls.now()

    class VirtualDate(_real_date):
        @classmethod
        def today(cls) -> Any:
            return VirtualDatetime.now().date()

    VirtualDatetime.__name__ = VirtualDatetime.__qualname__ = "datetime"
    VirtualDate.__name__ = VirtualDate.__qualname__ = "date"
    datetime_module.datetime = VirtualDatetime  # type: ignore[misc]
    datetime_module.date = VirtualDate  # type: ignore[misc]


def seed_everything(seed: int) -> None:
    """Seed `random` and numpy's global generator."""
    import numpy  # the warm parent has it already

    random.seed(seed)
    numpy.random.seed(seed % 2**32)
