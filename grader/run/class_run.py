"""Grade a class: from what was handed in to the gradebook."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from grader.checks.values import bounded
from grader.errors import SubmissionError
from grader.exercises import Exercise
from grader.results import CheckResult, ExerciseResult, Status
from grader.run.grade import grade_submission
from grader.run.gradebook import Gradebook, StudentResult, write_gradebook
from grader.run.launch import Launcher, new_launcher
from grader.run.schedule import Task, Work, grade_all
from grader.run.store import ResultStore, result_key
from grader.sandbox import Sandbox
from grader.submission import Submission
from grader.submission.discover import FoundSubmission


@dataclass(frozen=True, slots=True, kw_only=True)
class ClassRun:
    """How a class is graded."""

    sandbox: Sandbox
    """Where the students' nodes run."""
    hidden: bool
    """Whether the hidden checks run too."""
    jobs: int
    """How many submissions at once."""
    resume: bool
    """Whether to go on where an earlier run was stopped."""
    folder: Path
    """Where the gradebook is written."""


def tasks_of(
    found: Sequence[FoundSubmission], exercises: Mapping[str, Exercise], run: ClassRun
) -> list[Task]:
    """One task for each student and each exercise that anybody has handed in.

    Args:
        found: The submissions, by name of the student.
        exercises: Those to grade, by id, in the order of the workbook.
        run: How they are graded.
    """
    handed_in = {key for one in found for key in (*one.submissions, *one.unreadable)}
    handed_in &= set(exercises)
    # If nobody has handed in anything for them, each student is told so for all of them.
    wanted = [exercises[key] for key in exercises if key in handed_in or not handed_in]
    return [_task(one, exercise, run) for one in found for exercise in wanted]


def _task(found: FoundSubmission, exercise: Exercise, run: ClassRun) -> Task:
    fault = ""
    try:
        submission = found.submission(exercise)
    except SubmissionError as error:
        fault = str(error)
        notes = (fault,)
        submission = Submission(
            student=found.student, exercise_id=exercise.id, files={}, answers={}, notes=notes
        )
    key = result_key(submission, exercise, hidden=run.hidden, sandbox=run.sandbox)
    return Task(submission=submission, exercise=exercise, key=key, fault=fault)


def grade_class(
    tasks: Sequence[Task], run: ClassRun, *, on_done: Callable[[Task, ExerciseResult], None]
) -> Gradebook:
    """Grade every task, and write `gradebook.json`.

    Raises:
        GraderError: The gradebook cannot be written.
    """
    launcher = new_launcher()
    store = ResultStore(run.folder / "gradebook.sqlite")
    work = Work(
        grade=lambda task: _grade(task, run, launcher), on_done=on_done, stop=launcher.close
    )
    try:
        results = grade_all(tasks, work, store=store, jobs=run.jobs, resume=run.resume)
    finally:
        launcher.close()
        store.close()
    gradebook = Gradebook(sandbox=run.sandbox.name, submissions=_by_student(tasks, results))
    write_gradebook(gradebook, run.folder / "gradebook.json")
    return gradebook


def _grade(task: Task, run: ClassRun, launcher: Launcher) -> ExerciseResult:
    """Grade one task; a fault of ours becomes its result, so that the others go on."""
    try:
        result = grade_submission(
            task.submission,
            task.exercise,
            hidden=run.hidden,
            sandbox=run.sandbox,
            launcher=launcher,
        )
    except Exception as error:
        text = f"this is not your fault: {bounded(f'{type(error).__name__}: {error}', 500)}"
        return ExerciseResult.without_checks(task.exercise.id, Status.INFRASTRUCTURE, message=text)
    return _unreadable(result, task.fault) if task.fault else result


def _unreadable(result: ExerciseResult, fault: str) -> ExerciseResult:
    """The verdict on a notebook that cannot be read: an error, with the reason, in each check."""
    checks = [
        CheckResult(
            name=check.name,
            title=check.title,
            status=Status.ERROR,
            max_points=check.max_points,
            hidden=check.hidden,
            message=fault,
        )
        if check.status is Status.NOT_ATTEMPTED
        else check
        for check in result.checks
    ]
    return ExerciseResult.from_checks(result.exercise_id, checks, notes=result.notes)


def _by_student(
    tasks: Sequence[Task], results: Sequence[ExerciseResult]
) -> tuple[StudentResult, ...]:
    by_student: dict[str, list[ExerciseResult]] = {}
    for task, result in zip(tasks, results, strict=True):
        by_student.setdefault(task.submission.student, []).append(result)
    return tuple(
        StudentResult(student=student, exercises=tuple(exercises))
        for student, exercises in by_student.items()
    )
