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
