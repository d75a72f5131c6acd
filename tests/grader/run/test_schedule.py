import threading
import time

import pytest

from grader.results import CheckResult, ExerciseResult, Status
from grader.run.schedule import Task, Work, grade_all
from grader.run.store import ResultStore


@pytest.fixture
def store(tmp_path):
    store = ResultStore(tmp_path / "gradebook.sqlite")
    yield store
    store.close()


@pytest.fixture
def tasks(workbook):
    exercise = workbook.exercise
    return [
        Task(submission=workbook.submission(student=name), exercise=exercise, key=name)
        for name in "abcdef"
    ]


def result(name, status=Status.PASSED):
    return ExerciseResult.from_checks("9.1", [CheckResult(name=name, title="t", status=status)])


class Record:
    """A grader of tasks that remembers."""

    def __init__(self, delay=0.0, status=Status.PASSED):
        self.delay, self.status = delay, status
        self.graded, self.done, self.stopped = [], [], threading.Event()

    def work(self):
        return Work(grade=self.grade, on_done=self.on_done, stop=self.stopped.set)

    def grade(self, task):
        self.graded.append(task.key)
        time.sleep(self.delay * (ord("g") - ord(task.key)))
        return result(task.key, self.status)

    def on_done(self, task, outcome):
        self.done.append(task.key)


@pytest.mark.parametrize("jobs", [1, 3, 8])
def test_results_come_in_the_order_of_the_tasks(tasks, store, jobs):
    record = Record(delay=0.002)
    results = grade_all(tasks, record.work(), store=store, jobs=jobs, resume=False)
    assert results == [result(name) for name in "abcdef"]
    assert sorted(record.done) == list("abcdef")


def test_a_run_goes_on_where_it_was_stopped(tasks, store):
    first = Record()
    grade_all(tasks[:4], first.work(), store=store, jobs=2, resume=False)
    second = Record()
    results = grade_all(tasks, second.work(), store=store, jobs=2, resume=True)
    assert sorted(second.graded) == ["e", "f"]
    assert sorted(second.done) == list("abcdef")
    assert results == [result(name) for name in "abcdef"]


def test_without_resume_all_is_graded_again(tasks, store):
    grade_all(tasks, Record().work(), store=store, jobs=2, resume=False)
    again = Record()
    grade_all(tasks, again.work(), store=store, jobs=2, resume=False)
    assert sorted(again.graded) == list("abcdef")


def test_our_own_faults_are_graded_again(tasks, store):
    broken = Record(status=Status.INFRASTRUCTURE)
    grade_all(tasks, broken.work(), store=store, jobs=2, resume=False)
    again = Record()
    grade_all(tasks, again.work(), store=store, jobs=2, resume=True)
    assert sorted(again.graded) == list("abcdef")


def test_an_interrupted_run_keeps_what_it_has(tasks, store):
    record = Record()

    def interrupt(task, outcome):
        if task.key == "b":
            raise KeyboardInterrupt

    work = Work(grade=record.grade, on_done=interrupt, stop=record.stopped.set)
    with pytest.raises(KeyboardInterrupt):
        grade_all(tasks, work, store=store, jobs=1, resume=False)
    assert record.stopped.is_set()
    assert store.get("a") == result("a")
    assert store.get("b") == result("b")
