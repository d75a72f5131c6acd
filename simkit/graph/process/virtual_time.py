"""Node side: every clock, every die and every lock that a script can see belongs to the simulation."""

from __future__ import annotations

import _thread
import datetime as datetime_module
import random
import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any

from simkit.graph.process.scheduler import Scheduler, Task

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


class VirtualLock:
    """A lock that blocks its task, not the node: what `threading.Lock()` gives in a script."""

    def __init__(self, scheduler: Scheduler) -> None:
        self._scheduler = scheduler
        self._held = False
        self._queue: deque[Task] = deque()

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """As `threading.Lock.acquire`, in virtual time."""
        if self._take():
            return True
        if not blocking:
            return False
        scheduler = self._scheduler
        until = (
            None if timeout is None or timeout < 0 else scheduler.now_ns() + round(timeout * 1e9)
        )
        task = scheduler.current
        self._queue.append(task)
        while self._held and (until is None or scheduler.now_ns() < until):
            scheduler.block(until)
        self._queue.remove(task)
        return self._take()

    def _take(self) -> bool:
        if self._held:
            return False
        self._held = True
        return True

    def release(self) -> None:
        """As `threading.Lock.release`."""
        if not self._held:
            raise RuntimeError("release unlocked lock")
        self._held = False
        if self._queue:
            self._scheduler.make_ready(self._queue[0])

    def locked(self) -> bool:
        """As `threading.Lock.locked`."""
        return self._held

    def _at_fork_reinit(self) -> None:
        self._held = False

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()


class _RawEvent:
    """`threading.Event` for the start of a real thread, outside virtual time."""

    def __init__(self) -> None:
        self._lock = _thread.allocate_lock()
        self._lock.acquire()
        self._set = False

    def is_set(self) -> bool:
        return self._set

    def set(self) -> None:
        if not self._set:
            self._set = True
            self._lock.release()

    def wait(self, timeout: float | None = None) -> bool:
        if not self._set and self._lock.acquire(timeout=-1 if timeout is None else timeout):
            self._lock.release()
        return self._set


def virtualise_threading(scheduler: Scheduler) -> Callable[[], list[Task]]:
    """Make `threading` and `queue` of this process block in virtual time, one thread at a time.

    Returns:
        A function that lists the tasks of non-daemon threads that still run.
    """
    import queue

    original_init, original_start = threading.Thread.__init__, threading.Thread.start
    tasks: dict[threading.Thread, Task] = {}

    def init(self: threading.Thread, *args: object, **kwargs: object) -> None:
        original_init(self, *args, **kwargs)  # type: ignore[arg-type]
        self._started = _RawEvent()  # type: ignore[attr-defined]

    def start(self: threading.Thread) -> None:
        task = tasks[self] = scheduler.adopt(self.name)
        work = self.run
        self.run = lambda: scheduler.run_task(task, work)  # type: ignore[method-assign]
        original_start(self)
        scheduler.make_ready(task)

    def join(self: threading.Thread, timeout: float | None = None) -> None:
        if self not in tasks:
            raise RuntimeError("cannot join thread before it is started")
        scheduler.join(
            tasks[self], None if timeout is None else scheduler.now_ns() + round(timeout * 1e9)
        )

    def is_alive(self: threading.Thread) -> bool:
        return self in tasks and not tasks[self].done

    def lock() -> VirtualLock:
        return VirtualLock(scheduler)

    threading.Thread.__init__ = init  # type: ignore[method-assign]
    threading.Thread.start = start  # type: ignore[method-assign]
    threading.Thread.join = join  # type: ignore[method-assign]
    threading.Thread.is_alive = is_alive  # type: ignore[method-assign]
    threading.Lock = threading._allocate_lock = lock  # type: ignore[assignment,attr-defined]
    threading.RLock = threading._PyRLock  # type: ignore[attr-defined]
    queue.SimpleQueue = queue._PySimpleQueue  # type: ignore[attr-defined,misc]

    return lambda: [task for thread, task in tasks.items() if not thread.daemon and not task.done]
