"""Node side: one thread of a script runs at a time, and virtual time decides which.

Each thread of a node is a *task* with a gate. A task that blocks picks the next one to run: whoever is ready, in the order in
which they became ready; if nobody is, the whole node blocks and asks the graph, which answers with a later time or with events.
So a script with threads, timers and callbacks gives the same run every time.
"""

from __future__ import annotations

import _thread
import sys
from collections import deque
from collections.abc import Callable

from simkit.graph.process import failure

Exchange = Callable[[int | None], None]
"""Blocks the whole node until the given virtual time [ns] (None: until an event)."""


class Task:
    """One thread of the node."""

    __slots__ = (
        "blocked_since_asked",
        "done",
        "gate",
        "name",
        "ready",
        "sequence",
        "waiters",
        "wake_ns",
    )

    def __init__(self, name: str) -> None:
        self.name = name
        self.gate = _thread.allocate_lock()
        self.gate.acquire()
        self.ready = False
        self.wake_ns: int | None = None
        self.sequence = 0
        self.done = False
        self.waiters: list[Task] = []
        self.blocked_since_asked = True  # the first time is free


class Scheduler:
    """Hands the right to run from task to task.

    Args:
        exchange: Blocks the node as a whole; on return the virtual time may be later, and tasks may have been made ready.
        now_ns: Reads the virtual time [ns].
    """

    def __init__(self, exchange: Exchange, now_ns: Callable[[], int]) -> None:
        self._exchange = exchange
        self.now_ns = now_ns
        self._ready: deque[Task] = deque()
        self._sleeping: list[Task] = []
        self._sequence = 0
        self.main = Task("main")
        self.current = self.main
        self._tasks = [self.main]
        self._idents = {_thread.get_ident()}

    # -- what a running task may do

    def block(self, until_ns: int | None = None) -> None:
        """Block the calling task until it is made ready or virtual time reaches `until_ns`."""
        task = self.current
        task.blocked_since_asked = True
        task.wake_ns = until_ns
        if until_ns is not None:
            self._sequence += 1
            task.sequence = self._sequence
            self._sleeping.append(task)
        self._hand_over(task)
        if until_ns is not None and task in self._sleeping:
            self._sleeping.remove(task)
        task.wake_ns = None

    def make_ready(self, task: Task) -> None:
        """Let a blocked task go on when its turn comes."""
        if not task.ready and not task.done:
            task.ready = True
            self._ready.append(task)

    def start(self, work: Callable[[], None], name: str) -> Task:
        """Run `work` as a task of its own, first when the running one blocks."""
        task = self.adopt(name)
        _thread.start_new_thread(self.run_task, (task, work))
        self.make_ready(task)
        return task

    def adopt(self, name: str) -> Task:
        """A task for a thread that somebody else starts, and that runs `run_task`."""
        task = Task(name)
        self._tasks = [*(other for other in self._tasks if not other.done), task]
        return task

    def tasks(self) -> list[Task]:
        """Tasks that are not done, oldest first."""
        return [task for task in self._tasks if not task.done]

    def run_task(self, task: Task, work: Callable[[], None]) -> None:
        """The life of a task's thread: wait for the first turn, work, hand over for good."""
        task.gate.acquire()
        self._idents.add(_thread.get_ident())
        try:
            work()
        finally:
            self._idents.discard(_thread.get_ident())
            task.done = True
            if task.ready:
                # Made so while it ran, as by a shutdown, which wakes everybody: nobody is left to take its turn.
                self._ready.remove(task)
            for waiter in task.waiters:
                self.make_ready(waiter)
            self._pick().gate.release()

    def join(self, task: Task, until_ns: int | None = None) -> bool:
        """Block until a task is done or virtual time reaches `until_ns`; whether it is done."""
        while not task.done and (until_ns is None or self.now_ns() < until_ns):
            task.waiters.append(self.current)
            self.block(until_ns)
            task.waiters.remove(self.current)
        return task.done

    @property
    def sleeper_count(self) -> int:
        """How many tasks wait for a time."""
        return len(self._sleeping)

    def is_task(self) -> bool:
        """Whether the calling thread is one of ours (a thread made behind our back is not)."""
        return _thread.get_ident() in self._idents

    # -- handing over

    def _hand_over(self, task: Task) -> None:
        chosen = self._pick()
        if chosen is not task:
            chosen.gate.release()
            task.gate.acquire()
        self.current = task

    def _pick(self) -> Task:
        while not self._ready:
            times = [sleeper.wake_ns for sleeper in self._sleeping if sleeper.wake_ns is not None]
            self._exchange(min(times) if times else None)
            self._wake_sleepers()
        task = self._ready.popleft()
        task.ready = False
        self.current = task
        return task

    def _wake_sleepers(self) -> None:
        now = self.now_ns()
        due = [task for task in self._sleeping if task.wake_ns is not None and task.wake_ns <= now]
        for task in sorted(due, key=lambda sleeper: (sleeper.wake_ns, sleeper.sequence)):
            self._sleeping.remove(task)
            self.make_ready(task)


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
            failure.print_traceback(error, sys.stderr)
            self._report_fault(error)
