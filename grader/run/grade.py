"""Grade one submission to one exercise: the one way, for the notebook, the class and the workbook."""

from __future__ import annotations

import tempfile
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path

from grader.exercises import Exercise
from grader.results import CheckResult, ExerciseResult, Status
from grader.run.job import Job
from grader.run.launch import Launcher, default_launcher
from grader.run.supervise import Outcome, TimeLimits, supervise
from grader.sandbox import Sandbox, find_sandbox
from grader.submission import Submission, read_notebook, submission_of

_NOTES_SHOWN = 5
_REFERENCES: dict[tuple[Path, bool, str], frozenset[str]] = {}
"""What reference solutions pass in this process, by notebook: asked only where a check ended in an error."""


def grade_submission(
    submission: Submission,
    exercise: Exercise,
    *,
    hidden: bool,
    for_author: bool = False,
    sandbox: Sandbox | None = None,
    launcher: Launcher | None = None,
    limits: TimeLimits | None = None,
) -> ExerciseResult:
    """Run the checks of an exercise on a submission, in a process of their own.

    Args:
        submission: Files and answers of a student.
        exercise: What was asked for.
        hidden: Whether the hidden checks run too.
        for_author: Whether to say what only the author of the checks wants to know.
        sandbox: Where the student's nodes run; the strongest that works here if None.
        launcher: Starts the checker process; the quickest that works here if None.
        limits: Wall-clock limits.
    """
    attempted = submission.attempted(exercise)
    sandbox = sandbox or find_sandbox()
    with tempfile.TemporaryDirectory(prefix="grader-", ignore_cleanup_errors=True) as folder:
        job = Job(
            exercise=exercise,
            submission=submission,
            sandbox=sandbox,
            folder=Path(folder),
            hidden=hidden,
            only_list=not attempted,
            for_author=for_author,
        )
        checker = (launcher or default_launcher()).start(job.dumps())
        outcome = supervise(checker, limits or TimeLimits())
    if attempted:
        checks = decided(outcome)
        if outcome.transcript.faults:
            passed = reference_passes(exercise, hidden=hidden, sandbox=sandbox, launcher=launcher)
            checks = blamed(checks, outcome.transcript.faults, passed)
    else:
        why = _why_not_attempted(submission)
        checks = [_with(check, Status.NOT_ATTEMPTED, why) for check in _plan(outcome)]
    if not checks:
        return _broken(submission, exercise, outcome)
    return ExerciseResult.from_checks(exercise.id, checks, notes=submission.notes)


def decided(outcome: Outcome) -> list[CheckResult]:
    """The result of every planned check, also of those that the checker did not come to.

    What was told before the end stands. The check that was running gets the blame of the time, or
    is our fault if the checker died; those behind it were not run.
    """
    return [
        outcome.transcript.results.get(index) or _undecided(check, index, outcome)
        for index, check in enumerate(_plan(outcome))
    ]


def blamed(
    checks: Sequence[CheckResult], faults: Mapping[int, str], passed: Collection[str] | None
) -> list[CheckResult]:
    """The results, each error of a check a fault of ours if the reference solution does not pass that check.

    Args:
        checks: The results.
        faults: What is said of a fault of ours, by place of the check.
        passed: The checks that the reference solution passes; None if there is no solution here.
    """
    return [
        _with(check, Status.INFRASTRUCTURE, faults[index])
        if index in faults and passed is not None and check.name not in passed
        else check
        for index, check in enumerate(checks)
    ]


def reference_passes(
    exercise: Exercise, *, hidden: bool, sandbox: Sandbox, launcher: Launcher | None = None
) -> frozenset[str] | None:
    """The checks that the reference solution passes; None where a student works, who has none."""
    folder = exercise.hidden_checks.parent if exercise.hidden_checks else None
    path = folder / f"{exercise.slug}.ipynb" if folder else None
    if path is None or not path.is_file():
        return None
    key = (path, hidden, sandbox.name)
    if key not in _REFERENCES:
        solution = submission_of(read_notebook(path), exercise, student="solution")
        result = grade_submission(
            solution, exercise, hidden=hidden, for_author=True, sandbox=sandbox, launcher=launcher
        )
        good = [check.name for check in result.checks if check.status is Status.PASSED]
        _REFERENCES[key] = frozenset(good)
    return _REFERENCES[key]


def _undecided(check: CheckResult, index: int, outcome: Outcome) -> CheckResult:
    if outcome.overrun is None:
        return _with(check, Status.INFRASTRUCTURE, _reason(outcome))
    running = outcome.transcript.running
    if index == running:
        text = f"it was stopped: the checks had run for more than {outcome.overrun:g} s"
        hint = "Is there a loop that never sleeps, or one that publishes far too often?"
        return _with(check, Status.TIMEOUT, text, hint)
    names = outcome.transcript.plan
    blame = f" ({names[running].title})" if running is not None else ""
    return _with(check, Status.SKIPPED, f"not run: an earlier check took all the time{blame}")


def _with(check: CheckResult, status: Status, message: str, hint: str = "") -> CheckResult:
    return CheckResult(
        name=check.name,
        title=check.title,
        status=status,
        max_points=check.max_points,
        hidden=check.hidden,
        message=message,
        hint=hint,
    )


def _why_not_attempted(submission: Submission) -> str:
    if submission.files:
        return "nothing to check yet: the files are as they were given"
    return " ".join(["nothing was handed in.", *submission.notes[:_NOTES_SHOWN]])


def _plan(outcome: Outcome) -> Sequence[CheckResult]:
    return () if outcome.transcript.broken else outcome.transcript.plan


def _broken(submission: Submission, exercise: Exercise, outcome: Outcome) -> ExerciseResult:
    result = ExerciseResult.without_checks(
        exercise.id, Status.INFRASTRUCTURE, message=_reason(outcome)
    )
    return ExerciseResult.from_checks(exercise.id, result.checks, notes=submission.notes)


def _reason(outcome: Outcome) -> str:
    """Why a checker did not come to a verdict, for the instructor."""
    if outcome.transcript.broken:
        what = f"the checks cannot run: {outcome.transcript.broken}"
    elif outcome.fault:
        what = f"the checker process sent something impossible: {outcome.fault}"
    else:
        what = f"the checker process ended early (exit code {outcome.exit_code})"
    last = outcome.output.strip().splitlines()[-1:]
    return f"this is not your fault: {what}" + (f"; it said: {last[0][:300]}" if last else "")
