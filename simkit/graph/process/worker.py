"""Node side: the callbacks of one subscription, or the calls of one service, one after the other."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Callable

from simkit.graph.process import errors
from simkit.graph.process.scheduler import Scheduler, Task


class Worker:
    """Does jobs in order, in a task of its own, which begins with the first job and ends with `close`.

    Args:
        scheduler: Of the node.
        name: Name of the task.
        report_fault: Told of what a job raises; the jobs go on.
        queue_size: At most so many jobs wait; the oldest is dropped, as rospy's full queue does while a callback sleeps.
    """

    def __init__(
        self,
        scheduler: Scheduler,
        name: str,
        report_fault: Callable[[BaseException], None],
        queue_size: int | None = None,
    ) -> None:
        self._scheduler = scheduler
        self._name = name
        self._report_fault = report_fault
        self._task: Task | None = None
        self._idle = False
        self._closed = False
        self._jobs: deque[Callable[[], None]] = deque(maxlen=queue_size or None)

    def add(self, job: Callable[[], None]) -> None:
        """Do a job after those that wait; not to be called after `close`."""
        self._jobs.append(job)
        if self._task is None:
            self._task = self._scheduler.start(self._run, self._name)
        else:
            self._wake()

    def close(self, *, drop: bool) -> None:
        """End the task, and so its thread; a job may close its own worker, and is done to its end.

        Args:
            drop: Forget the jobs that wait; otherwise they are done first.
        """
        self._closed = True
        if drop:
            self._jobs.clear()
        self._wake()

    def _wake(self) -> None:
        # Only from here: a job that sleeps must not be woken.
        if self._task is not None and self._idle:
            self._scheduler.make_ready(self._task)

    def _run(self) -> None:
        while True:
            while self._jobs:
                self._run_one(self._jobs.popleft())
            if self._closed:
                return
            self._idle = True
            self._scheduler.block()
            self._idle = False

    def _run_one(self, job: Callable[[], None]) -> None:
        try:
            job()
        except Exception as error:
            # rospy catches what a callback raises; what comes here is a fault of ours, and must not end the thread
            errors.print_traceback(error, sys.stderr)
            self._report_fault(error)
