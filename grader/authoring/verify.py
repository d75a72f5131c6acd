"""Verify a workbook: every law, over all its exercises, each finding with file and remedy."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from grader.authoring.findings import Finding
from grader.authoring.laws_of_checks import check_files_are_sound
from grader.authoring.laws_of_files import complete, files_of, fresh, nothing_else, nothing_leaks
from grader.authoring.laws_of_grades import Trial, trials_of
from grader.authoring.lectures import fresh_lectures
from grader.authoring.source import Source, load_source, source_paths
from grader.errors import GraderError, SourceError
from grader.exercises import SLUG_PATTERN, Exercise
from grader.results import ExerciseResult
from grader.submission import Submission

Grade = Callable[[Submission, Exercise], ExerciseResult]
"""Grades one submission with public and hidden checks; called from several threads."""


def verify(
    root: Path, *, jobs: int = 1, only: str | None = None, grade: Grade | None = None
) -> list[Finding]:
    """Hold a workbook to its laws.

    Args:
        root: Folder of the workbook.
        jobs: How many submissions are graded at once.
        only: Verify this exercise alone, e.g. "3.1".
        grade: Grades a submission; in the strongest sandbox that works here if None.

    Returns:
        What is wrong with files, then with solutions, then with variants of those that pass; nothing if all is well.

    Raises:
        GraderError: `only` names no exercise.
    """
    findings: list[Finding] = []
    sources: list[Source] = []
    for path in source_paths(root):
        try:
            sources.append(load_source(path))
        except SourceError as error:
            line = f":{error.line}" if error.line is not None else ""
            findings.append(
                Finding(file=f"solutions/{error.file}{line}", what=error.text, remedy="correct it")
            )
    if only is None:
        findings += _whole_tree(root)
    else:
        sources = [source for source in sources if source.definition.id == only]
        if not sources and not findings:
            raise GraderError(f"no source of exercise {only} in solutions/")
    trials: list[Trial] = []
    for source in sources:
        findings += _without_grading(root, source)
        if all((root / name).is_file() for name in files_of(source)[:3]):
            more, faults = trials_of(root, source)
            trials += more
            findings += faults
    return findings + _graded(trials, grade or _default_grade(), jobs)


def _whole_tree(root: Path) -> list[Finding]:
    slugs = [path.stem for path in source_paths(root)]
    keys = [f"{found[1]}_{found[2]}" for slug in slugs if (found := SLUG_PATTERN.fullmatch(slug))]
    findings = [*nothing_else(root, slugs=slugs, keys=keys), *fresh_lectures(root)]
    for slug in slugs:
        same = [other for other in slugs if other[:4] == slug[:4]]
        if same[0] != slug:
            findings.append(
                Finding(
                    file=f"solutions/{slug}.md",
                    what=f"has the number of {same[0]}.md",
                    remedy="give it another",
                )
            )
    if not slugs:
        findings.append(
            Finding(file="solutions/", what="has no source", remedy="begin one: `grader new`")
        )
    return findings


def _without_grading(root: Path, source: Source) -> list[Finding]:
    checks = [name for name in files_of(source) if name.endswith(".py")]
    return [
        *complete(root, source),
        *fresh(root, source),
        *check_files_are_sound(root, source.definition, names=checks),
        *nothing_leaks(source),
    ]


def _graded(trials: list[Trial], grade: Grade, jobs: int) -> list[Finding]:
    """The findings of all trials; variants of a solution that fails would fail with it, and are left out."""
    firsts = [trial for trial in trials if not trial.is_variant]
    findings, failing = _judged(firsts, grade, jobs)
    variants = [one for one in trials if one.is_variant and one.exercise.id not in failing]
    return findings + _judged(variants, grade, jobs)[0]


def _judged(trials: list[Trial], grade: Grade, jobs: int) -> tuple[list[Finding], set[str]]:
    """What is found, and the exercises whose solution it is found in."""
    with ThreadPoolExecutor(max_workers=max(jobs, 1)) as pool:
        results = list(pool.map(lambda trial: grade(trial.submission, trial.exercise), trials))
    findings: list[Finding] = []
    failing: set[str] = set()
    for trial, result in zip(trials, results, strict=True):
        found = trial.judge(result)
        findings += found
        if found and trial.submission.student == "solution":
            failing.add(trial.exercise.id)
    return findings, failing


def _default_grade() -> Grade:
    # Imported here: starting checkers is of no use to those who bring their own.
    from grader.run import grade_submission
    from grader.sandbox import find_sandbox

    sandbox = find_sandbox()
    return lambda submission, exercise: grade_submission(
        submission, exercise, hidden=True, for_author=True, sandbox=sandbox
    )
