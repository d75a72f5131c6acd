"""Many submissions at once: as many checkers as asked for, the same results in any order."""

from __future__ import annotations

import concurrent.futures
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from grader.exercises import Exercise
from grader.results import ExerciseResult, Status
from grader.run.store import ResultStore
from grader.submission import Submission


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """One submission to grade."""

    submission: Submission
    exercise: Exercise
    key: str
    """What its result is stored under."""
    fault: str = ""
    """Why what was handed in cannot be read; empty if it can."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Work:
    """What `grade_all` does with a task, and whom it tells."""

    grade: Callable[[Task], ExerciseResult]
    """Grades one task; called from several threads, raises nothing."""
    on_done: Callable[[Task, ExerciseResult], None]
    """Told of each result when it is there, in any order."""
    stop: Callable[[], None]
    """Ends what is running, when the run is interrupted."""


def default_jobs() -> int:
    """How many checkers run at once if nobody says."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def grade_all(
    tasks: Sequence[Task], work: Work, *, store: ResultStore, jobs: int, resume: bool
) -> list[ExerciseResult]:
    """Grade every task; the results in the order of the tasks.

    Each result is stored as soon as it is there. If this is interrupted, those are kept.

    Args:
        tasks: What to grade.
        work: How.
        store: Takes each result.
        jobs: How many at once.
        resume: Whether results that the store has are taken from it. Our own faults are not.
    """
    results: dict[int, ExerciseResult] = {}
    for index, task in enumerate(tasks):
        known = store.get(task.key) if resume else None
        if known is not None and known.status is not Status.INFRASTRUCTURE:
            results[index] = known
            work.on_done(task, known)
    with concurrent.futures.ThreadPoolExecutor(max_workers=jobs) as pool:
        running = {
            pool.submit(work.grade, task): index
            for index, task in enumerate(tasks)
            if index not in results
        }
        try:
            for future in concurrent.futures.as_completed(running):
                index = running[future]
                task, result = tasks[index], future.result()
                store.put(task.key, student=task.submission.student, result=result)
                results[index] = result
                work.on_done(task, result)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            work.stop()
            raise
    return [results[index] for index in range(len(tasks))]
