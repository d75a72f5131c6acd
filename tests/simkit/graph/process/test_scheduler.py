"""One thread at a time, in an order that virtual time decides."""

import pytest

from simkit.graph.process.virtual_threads import VirtualLock


def test_a_sleep_asks_for_its_time_once(clock):
    clock.sleep(100)
    assert clock.now_ns == 100
    assert clock.waits == [100]


def test_a_new_task_runs_first_when_the_running_one_blocks(clock):
    seen = []
    task = clock.scheduler.start(lambda: seen.append("task"), "task")
    seen.append("main")
    clock.sleep(1)
    assert seen == ["main", "task"]
    assert task.done


def test_tasks_interleave_by_their_sleeps_the_same_each_time(make_clock):
    def run():
        clock, seen = make_clock(), []

        def work(name, period):
            for _ in range(4):
                clock.sleep(period)
                seen.append((clock.now_ns, name))

        tasks = [
            clock.scheduler.start(lambda n=name, p=period: work(n, p), name)
            for name, period in (("a", 3), ("b", 2), ("c", 6))
        ]
        for task in tasks:
            clock.scheduler.join(task)
        return seen, clock.waits

    seen, waits = run()
    # Who fell asleep first wakes first where times are equal.
    assert seen == [
        *[(2, "b"), (3, "a"), (4, "b")],
        *[(6, "c"), (6, "a"), (6, "b"), (8, "b"), (9, "a")],
        *[(12, "c"), (12, "a"), (18, "c"), (24, "c")],
    ]
    assert waits == sorted(waits)
    assert run() == (seen, waits)


def test_a_task_that_is_made_ready_wakes_early(clock):
    woken = []

    def sleeper():
        clock.scheduler.block(1000)
        woken.append(clock.now_ns)

    task = clock.scheduler.start(sleeper, "sleeper")
    clock.sleep(10)
    clock.scheduler.make_ready(task)
    clock.scheduler.make_ready(task)
    clock.sleep(10)
    assert woken == [10]
    assert clock.waits == [10, 20]


def test_ready_tasks_run_in_the_order_in_which_they_became_ready(clock):
    seen = []

    def work(name):
        clock.scheduler.block()
        seen.append(name)

    tasks = {name: clock.scheduler.start(lambda n=name: work(n), name) for name in "abc"}
    clock.sleep(1)
    for name in "cab":
        clock.scheduler.make_ready(tasks[name])
    clock.sleep(1)
    assert "".join(seen) == "cab"


def test_join_waits_for_the_end_or_for_a_time(clock):
    task = clock.scheduler.start(lambda: clock.sleep(50), "long")
    assert clock.scheduler.join(task, 20) is False
    assert clock.now_ns == 20
    assert clock.scheduler.join(task) is True
    assert clock.now_ns == 50
    assert clock.scheduler.join(task) is True
    assert clock.scheduler.tasks() == [clock.scheduler.main]


def test_an_event_wakes_a_node_that_waits_for_ever(clock):
    def arrive():
        clock.now_ns = 77
        clock.scheduler.make_ready(clock.scheduler.main)

    clock.on_wait = arrive
    clock.scheduler.block()
    assert (clock.now_ns, clock.waits) == (77, [None])


def test_a_lock_blocks_tasks_in_virtual_time(clock):
    lock, seen = VirtualLock(clock.scheduler), []

    def work(name, hold):
        with lock:
            seen.append((name, "in", clock.now_ns))
            clock.sleep(hold)

    tasks = [clock.scheduler.start(lambda n=name: work(n, 10), name) for name in "ab"]
    for task in tasks:
        clock.scheduler.join(task)
    assert seen == [("a", "in", 0), ("b", "in", 10)]
    assert not lock.locked()


def test_a_lock_can_be_waited_for_in_vain(clock):
    lock = VirtualLock(clock.scheduler)
    assert lock.acquire()
    assert not lock.acquire(blocking=False)
    assert not lock.acquire(timeout=5e-9)
    assert clock.now_ns == 5
    lock.release()
    with pytest.raises(RuntimeError, match="release unlocked lock"):
        lock.release()


def test_foreign_threads_are_told_from_tasks(clock):
    import threading

    answers = []
    thread = threading.Thread(target=lambda: answers.append(clock.scheduler.is_task()))
    thread.start()
    thread.join()
    assert answers == [False]
    assert clock.scheduler.is_task()
