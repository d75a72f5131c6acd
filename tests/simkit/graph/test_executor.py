"""Virtual time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph import Executor, GraphError


def test_events_run_in_order_of_time_then_of_scheduling():
    executor, seen = Executor(), []
    for name, time_ns in [("c", 30), ("a", 10), ("b1", 20), ("b2", 20)]:
        executor.call_at(time_ns, lambda name=name: seen.append((name, executor.now_ns)))
    executor.run_to(100)
    assert seen == [("a", 10), ("b1", 20), ("b2", 20), ("c", 30)]
    assert executor.now_ns == 100


@given(st.lists(st.integers(0, 50), max_size=40), st.integers(0, 60))
def test_run_to_runs_exactly_what_is_due(times, end):
    executor, seen = Executor(), []
    for time_ns in times:
        executor.call_at(time_ns, lambda: seen.append(executor.now_ns))
    executor.run_to(end)
    assert seen == sorted(t for t in times if t <= end)
    executor.run_to(1000)
    assert seen == sorted(times)


@given(st.lists(st.integers(1, 20), min_size=1, max_size=10))
def test_many_short_runs_equal_one_long_run(slices):
    def ticks(ends):
        executor, seen = Executor(), []

        def tick():
            seen.append(executor.now_ns)
            executor.call_at(executor.now_ns + 7, tick)

        executor.call_at(3, tick)
        for end in ends:
            executor.run_to(end)
        return seen

    ends = [sum(slices[: i + 1]) for i in range(len(slices))]
    assert ticks(ends) == ticks(ends[-1:])


def test_time_never_goes_back():
    executor = Executor(100)
    seen = []
    executor.call_at(5, lambda: seen.append(executor.now_ns))
    executor.run_to(50)
    assert seen == []
    assert executor.now_ns == 100
    executor.run_to(100)
    assert seen == [100]


def test_a_cancelled_event_never_runs():
    executor, seen = Executor(), []
    event = executor.call_at(5, lambda: seen.append("no"))
    executor.call_at(1, event.cancel)
    executor.run_to(10)
    assert seen == []
    assert executor.next_time_ns() is None


def test_stop_ends_the_run_at_that_instant():
    executor, seen = Executor(), []
    for time_ns in (1, 2, 3):
        executor.call_at(time_ns, lambda time_ns=time_ns: seen.append(time_ns))
    assert executor.run_to(10, lambda: len(seen) == 2) is True
    assert executor.now_ns == 2
    assert executor.run_to(10, lambda: False) is False


def test_a_callback_cannot_run_the_loop_again():
    executor = Executor()
    executor.call_at(1, lambda: executor.run_to(5))
    with pytest.raises(GraphError, match="already running"):
        executor.run_to(10)
    executor.run_to(20)  # and the loop is usable afterwards
    assert executor.now_ns == 20


class Mover:
    """Something that moves in steps of 1 ms; at some of them it makes an event."""

    def __init__(self, executor, *, speaks_at=()):
        self.executor = executor
        self.steps = []
        self.heard = []
        self.speaks_at = speaks_at
        executor.attach(self.move)

    def move(self, until_ns):
        while self.executor.now_ns + 1_000_000 <= until_ns:
            self.executor.pass_time(self.executor.now_ns + 1_000_000)
            now = self.executor.now_ns
            self.steps.append(now)
            if now in self.speaks_at:
                self.executor.call_soon(lambda: self.heard.append(self.executor.now_ns))
            if self.executor.has_due():
                return


def test_something_moves_between_events_up_to_each():
    executor = Executor()
    mover = Mover(executor)
    seen = []
    executor.call_at(2_500_000, lambda: seen.append(len(mover.steps)))
    executor.run_to(4_000_000)
    # Its steps begin where the clock stands: the event at 2.5 ms cuts one short.
    assert seen == [2]
    assert mover.steps == [1_000_000, 2_000_000, 3_500_000]
    assert executor.now_ns == 4_000_000


def test_what_moves_stops_for_the_events_that_it_makes_also_at_the_end():
    executor = Executor()
    mover = Mover(executor, speaks_at=(2_000_000, 5_000_000))
    executor.run_to(5_000_000)
    assert mover.heard == [2_000_000, 5_000_000]
    assert mover.steps == [n * 1_000_000 for n in range(1, 6)]


def test_one_step_of_events_takes_along_what_moves():
    executor = Executor()
    mover = Mover(executor, speaks_at=(1_000_000,))
    executor.call_at(3_000_000, lambda: None)
    assert executor.step()
    assert (mover.heard, executor.now_ns) == ([1_000_000], 1_000_000)
    assert executor.step()
    assert executor.now_ns == 3_000_000
    assert not executor.step()


def test_a_run_that_waits_looks_each_millisecond_while_something_moves():
    executor = Executor()
    mover = Mover(executor)
    assert executor.run_to(10_000_000, lambda: len(mover.steps) == 3)
    assert executor.now_ns == 3_000_000
    executor.attach(None)
    assert not executor.run_to(10_000_000, lambda: len(mover.steps) == 4)


def test_the_clock_can_be_set_only_while_nothing_has_happened():
    fresh, scheduled, run = Executor(7), Executor(7), Executor(7)
    assert fresh.begin_at(0)
    assert fresh.now_ns == 0
    scheduled.call_at(8, lambda: None)
    run.run_to(9)
    assert not scheduled.begin_at(0)
    assert not run.begin_at(0)
    assert (scheduled.now_ns, run.now_ns) == (7, 9)
