"""Laws of grades: what the checks say to the stub, the solution, and variants of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from grader.authoring.findings import Finding
from grader.authoring.notebook_text import solution_notebook, student_notebook
from grader.authoring.source import Source
from grader.authoring.variants import Variant, load_variants
from grader.errors import SourceError
from grader.exercises import Exercise, exercise_from_notebook, exercise_key
from grader.results import CheckResult, ExerciseResult, Status
from grader.submission import Notebook, Submission, notebook_from_bytes, submission_of

_REJECTED = (Status.FAILED, Status.ERROR, Status.TIMEOUT)


@dataclass(frozen=True, slots=True, kw_only=True)
class Trial:
    """One submission to be graded, and what must come of it."""

    exercise: Exercise
    submission: Submission
    judge: Callable[[ExerciseResult], list[Finding]]
    """The findings that follow from its result."""
    is_variant: bool = False
    """Whether it is a variant: tried only where the solution passes."""


def trials_of(root: Path, source: Source) -> tuple[list[Trial], list[Finding]]:
    """Everything to be graded to verify an exercise, and what is wrong before that.

    The notebooks are made from the source here, so that stale files do not matter.
    """
    released = _read(student_notebook(source), source)
    path = root / "exercises" / f"{source.slug}.ipynb"
    exercise = exercise_from_notebook(released, path=path, root=root)
    solution = submission_of(_read(solution_notebook(source), source), exercise, student="solution")
    stub = submission_of(released, exercise, student="stub")
    file = f"solutions/{source.slug}.md"
    findings = [
        Finding(file=file, what=f"reading its solution notes: {note}", remedy="change the cell")
        for note in solution.notes
    ]
    trials = [
        Trial(exercise=exercise, submission=stub, judge=lambda result: _stub(file, result)),
        *_twice(exercise, solution, file),
    ]
    variants = root / "solutions" / f"variants_{exercise_key(exercise.id)}.toml"
    if variants.is_file():
        more, faults = _variant_trials(variants, exercise, solution)
        trials += more
        findings += faults
    return trials, findings


def _read(text: str, source: Source) -> Notebook:
    return notebook_from_bytes(text.encode("utf-8"), name=f"{source.slug}.ipynb")


def _stub(file: str, result: ExerciseResult) -> list[Finding]:
    wrong = [check for check in result.checks if check.status is not Status.NOT_ATTEMPTED]
    if result.status is Status.NOT_ATTEMPTED and not wrong and result.points == 0:
        return []
    told = f"{wrong[0].name}: {wrong[0].message}" if wrong else ""
    return [
        Finding(
            file=file,
            what=f"the untouched exercise is '{result.status}' with {result.points:g} points {told}",
            remedy="an exercise as given must be 'not attempted' in every check",
        )
    ]


def _twice(exercise: Exercise, solution: Submission, file: str) -> list[Trial]:
    """The solution two times: it passes, and the second time is as the first."""
    results: list[ExerciseResult] = []

    def judge(result: ExerciseResult) -> list[Finding]:
        results.append(result)
        if len(results) == 1:
            return _not_passed(file, "the solution", result)
        if result == results[0]:
            return []
        remedy = "take chance from `rng` and time from `sim` in the checks"
        return [Finding(file=file, what="the solution's two results differ", remedy=remedy)]

    return [Trial(exercise=exercise, submission=solution, judge=judge) for _ in range(2)]


def _not_passed(file: str, who: str, result: ExerciseResult) -> list[Finding]:
    """The checks that did not pass: each cause once, with its log, and how many were skipped for it."""
    failed = [check for check in result.checks if check.status is not Status.PASSED]
    causes = [check for check in failed if check.status is not Status.SKIPPED] or failed
    skipped = len(failed) - len(causes)
    findings, logs = [], set()
    for check in causes:
        new_log = "" if check.log in logs else check.log
        logs.add(check.log)
        findings.append(
            Finding(
                file=file,
                what=f"{who} does not pass {check.name} ({check.status}): {check.message}",
                remedy=_remedy(check),
                log=new_log,
            )
        )
    if skipped:
        more = f"{findings[-1].remedy}; {skipped} more skipped, since they build on it"
        findings[-1] = replace(findings[-1], remedy=more)
    return findings


def _remedy(check: CheckResult) -> str:
    is_fault = check.status is Status.INFRASTRUCTURE
    return "correct the check" if is_fault else "correct the check or the solution"


def _variant_trials(
    path: Path, exercise: Exercise, solution: Submission
) -> tuple[list[Trial], list[Finding]]:
    trials: list[Trial] = []
    findings: list[Finding] = []
    try:
        variants = load_variants(path)
    except SourceError as error:
        return [], [_fault(error)]
    for variant in variants:
        try:
            submission = variant.apply(solution)
        except SourceError as error:
            findings.append(_fault(error))
            continue
        trials.append(
            Trial(
                exercise=exercise,
                submission=replace(submission, student="variant"),
                judge=_judge_of(variant),
                is_variant=True,
            )
        )
    if not any(not variant.is_right for variant in variants):
        findings.append(
            Finding(
                file=f"solutions/{path.name}",
                what="has no wrong variant",
                remedy="add one that a student might write, and the check that must reject it",
            )
        )
    return trials, findings


def _fault(error: SourceError) -> Finding:
    line = f":{error.line}" if error.line is not None else ""
    return Finding(file=f"solutions/{error.file}{line}", what=error.text, remedy="correct it")


def _judge_of(variant: Variant) -> Callable[[ExerciseResult], list[Finding]]:
    file = f"solutions/{variant.path.name}:{variant.line}"

    def accept(result: ExerciseResult) -> list[Finding]:
        return _not_passed(file, f"the right variant {variant.name!r}", result)

    def reject(result: ExerciseResult) -> list[Finding]:
        return [*_faults_of_checks(file, variant, result), *_rejection(file, variant, result)]

    return accept if variant.is_right else reject


def _faults_of_checks(file: str, variant: Variant, result: ExerciseResult) -> Iterator[Finding]:
    """A check that breaks down has a fault of its own, whatever the variant did to it."""
    for check in result.checks:
        if check.status is Status.INFRASTRUCTURE:
            what = f"the wrong variant {variant.name!r} breaks {check.name}: {check.message}"
            yield Finding(file=file, what=what, remedy="correct the check", log=check.log)


def _rejection(file: str, variant: Variant, result: ExerciseResult) -> Iterator[Finding]:
    who = f"the wrong variant {variant.name!r}"
    check = next((one for one in result.checks if one.name == variant.check), None)
    if check is None:
        names = ", ".join(one.name for one in result.checks)
        yield Finding(
            file=file, what=f"no check {variant.check}", remedy=f"name one of these: {names}"
        )
        return
    if check.status is Status.INFRASTRUCTURE:
        return  # said already, as a fault of the check
    if check.status not in _REJECTED:
        others = [one.name for one in result.checks if one.status in _REJECTED]
        yield Finding(
            file=file,
            what=f"{who} is '{check.status}' in {check.name}, rejected by: {others or 'no check'}",
            remedy="sharpen the check, or name the one that rejects it",
        )
        return
    if variant.says not in check.message and variant.says not in check.hint:
        yield Finding(
            file=file,
            what=f"{who} is told {check.message!r}, hint {check.hint!r}: no {variant.says!r}",
            remedy="make the check name this fault, or correct `says`",
        )
    if check.status is Status.FAILED and not check.hint:
        yield Finding(
            file=file,
            what=f"{who} gets no hint from {check.name}",
            remedy="give its expectation one",
        )
