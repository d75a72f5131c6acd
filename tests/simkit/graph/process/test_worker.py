"""Jobs one after the other, in a task that ends."""

import pytest

from simkit.graph.process.worker import Worker


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
