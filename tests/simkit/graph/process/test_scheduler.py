"""One thread at a time, in an order that virtual time decides."""

import pytest

from simkit.graph.process.scheduler import Worker
from simkit.graph.process.virtual_time import VirtualLock


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


# -- jobs one after the other, in a task that ends


@pytest.fixture
def faults():
    return []


@pytest.fixture
def worker(clock, faults):
    return Worker(clock.scheduler, "worker", faults.append)


def _others(clock):
    return [task.name for task in clock.scheduler.tasks() if task is not clock.scheduler.main]


def test_jobs_are_done_in_order_by_one_task(clock, worker):
    seen = []
    for name in "ab":
        worker.add(lambda n=name: (clock.sleep(3), seen.append((clock.now_ns, n))))
    assert seen == []
    clock.sleep(10)
    worker.add(lambda: seen.append((clock.now_ns, "c")))
    clock.sleep(10)
    assert seen == [(3, "a"), (6, "b"), (10, "c")]
    assert _others(clock) == ["worker"]


def test_a_full_queue_loses_its_oldest_job(clock, faults):
    worker, seen = Worker(clock.scheduler, "worker", faults.append, 2), []
    for name in "abc":
        worker.add(lambda n=name: seen.append(n))
    clock.sleep(1)
    assert seen == ["b", "c"]


def test_a_job_that_raises_is_reported_and_the_next_is_done(clock, worker, faults, capsys):
    seen = []
    worker.add(lambda: 1 / 0)
    worker.add(lambda: seen.append("next"))
    clock.sleep(1)
    assert seen == ["next"]
    assert [type(fault) for fault in faults] == [ZeroDivisionError]
    assert "ZeroDivisionError" in capsys.readouterr().err


def test_an_idle_worker_that_is_closed_ends_its_task(clock, worker):
    worker.add(lambda: None)
    clock.sleep(1)
    worker.close(drop=True)
    clock.sleep(1)
    assert _others(clock) == []
    assert clock.waits == [1, 2]


def test_a_worker_without_a_job_is_closed_without_a_task(clock, worker):
    worker.close(drop=True)
    clock.sleep(1)
    assert _others(clock) == []


@pytest.mark.parametrize(("drop", "done"), [(True, ["a"]), (False, ["a", "b", "c"])])
def test_what_waits_is_dropped_or_done_first(clock, worker, drop, done):
    seen = []
    for name in "abc":
        worker.add(lambda n=name: (clock.sleep(4), seen.append(n)))
    clock.sleep(1)
    worker.close(drop=drop)
    clock.sleep(20)
    assert seen == done
    assert _others(clock) == []


def test_a_worker_closed_before_its_first_turn_does_nothing(clock, worker):
    seen = []
    worker.add(lambda: seen.append("job"))
    worker.close(drop=True)
    clock.sleep(1)
    assert seen == []
    assert _others(clock) == []


def test_a_job_that_sleeps_is_not_woken_by_the_close(clock, worker):
    woken = []
    worker.add(lambda: (clock.scheduler.block(50), woken.append(clock.now_ns)))
    clock.sleep(10)
    worker.close(drop=True)
    clock.sleep(90)
    assert woken == [50]


def test_a_job_may_close_its_own_worker_and_goes_on_to_its_end(clock, worker):
    seen = []

    def job():
        worker.close(drop=True)
        clock.scheduler.block(5)
        seen.append(clock.now_ns)

    worker.add(job)
    worker.add(lambda: seen.append("dropped"))
    clock.sleep(10)
    assert seen == [5]
    assert _others(clock) == []


def test_other_tasks_keep_their_order_when_a_worker_ends(make_clock):
    def run(close):
        clock, seen = make_clock(), []
        worker = Worker(clock.scheduler, "worker", seen.append)
        worker.add(lambda: None)

        def wait(name):
            clock.scheduler.block()
            seen.append(name)

        tasks = {name: clock.scheduler.start(lambda n=name: wait(n), name) for name in "abc"}
        clock.sleep(1)
        for name in "cab":
            clock.scheduler.make_ready(tasks[name])
            if close and name == "c":
                worker.close(drop=True)
        clock.sleep(1)
        return seen, clock.waits

    assert run(close=True) == run(close=False) == (["c", "a", "b"], [1, 2])
