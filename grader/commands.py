"""What each command of `grader` does with its options."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from grader.errors import GraderError
from grader.exercises import Exercise, find_root, get_exercise, load_exercises
from grader.results import Status
from grader.submission.discover import FoundSubmission, discover
from simkit.errors import UnknownNameError

OK = 0
FINDINGS = 1
FAULT = 2


def _root(options: argparse.Namespace) -> Path:
    return find_root(options.root if options.root is not None else Path.cwd())


def grade(options: argparse.Namespace) -> int:
    """`grader grade PATH...`."""
    from grader.report import print_gradebook, progress
    from grader.run.class_run import ClassRun, grade_class, tasks_of
    from grader.run.schedule import default_jobs
    from grader.sandbox import find_sandbox

    root = _root(options)
    exercises = load_exercises(root)
    found = _discover(options, exercises)
    graded = _only(options.only, root, exercises)
    options.out.mkdir(parents=True, exist_ok=True)
    sandbox = find_sandbox(
        private=(root, *options.paths, options.out), require=options.require_sandbox
    )
    if sandbox.name == "none":
        print(f"grader: no sandbox: {sandbox.reason}", file=sys.stderr)
    run = ClassRun(
        sandbox=sandbox,
        hidden=not options.no_hidden,
        jobs=options.jobs or default_jobs(),
        resume=options.resume,
        folder=options.out,
    )
    tasks = tasks_of(found, graded, run)
    with progress(len(tasks), sys.stderr) as advance:
        gradebook = grade_class(tasks, run, on_done=lambda _task, _result: advance())
    print_gradebook(gradebook, sys.stdout)
    print(f"gradebook: {options.out / 'gradebook.json'}")
    results = [result for entry in gradebook.submissions for result in entry.exercises]
    return FAULT if any(r.status is Status.INFRASTRUCTURE for r in results) else OK


def _discover(options: argparse.Namespace, exercises: dict[str, Exercise]) -> list[FoundSubmission]:
    found = discover(options.paths, exercises)
    if not found:
        raise GraderError(f"no submission in {', '.join(map(str, options.paths))}")
    if options.student is None:
        return found
    chosen = [one for one in found if one.student == options.student]
    if not chosen:
        raise UnknownNameError("student", options.student, [one.student for one in found])
    return chosen


def _only(exercise_id: str | None, root: Path, known: dict[str, Exercise]) -> dict[str, Exercise]:
    if exercise_id is None:
        return known
    return {exercise_id: get_exercise(root, exercise_id)}


def check(options: argparse.Namespace) -> int:
    """`grader check ID`: the notebook's check, on what lies in the working folder."""
    from grader.notebook import check_folder

    root = _root(options)
    report = check_folder(root, get_exercise(root, options.id), None)
    print(report)
    if report.result is None or report.result.status is Status.INFRASTRUCTURE:
        return FAULT
    return OK if report.passed else FINDINGS


def build(options: argparse.Namespace) -> int:
    """`grader build [--check]`."""
    from grader.authoring import build as building

    root = _root(options)
    if options.check:
        return _findings(building.check(root), "every notebook is as its source says")
    written = building.build(root)
    for path in written:
        print(f"built {path.relative_to(root).as_posix()}")
    if not written:
        print("every notebook is as its source says")
    return OK


def start(options: argparse.Namespace) -> int:
    """`grader start ID|all`."""
    from grader.authoring.start import start as start_exercise
    from grader.authoring.start import start_lectures, start_page_of

    root = _root(options)
    ids = list(load_exercises(root)) if options.id == "all" else [options.id]
    for exercise_id in ids:
        started = start_exercise(root, exercise_id)
        for message in started.messages:
            print(message)
    for message in (*start_lectures(root), *start_page_of(root)):  # exercises link to them
        print(message)
    return OK


def new(options: argparse.Namespace) -> int:
    """`grader new ID --title TITLE [--like ID]`."""
    from grader.authoring.new import new_exercise

    root = _root(options)
    for path in new_exercise(root, options.id, title=options.title, like=options.like):
        print(f"made {path.relative_to(root).as_posix()}")
    print(
        "next: fill in each place that says FILL IN, then `grader build`"
        f" and `grader verify --only {options.id}`"
    )
    return OK


def verify(options: argparse.Namespace) -> int:
    """`grader verify`."""
    from grader.authoring import verify as verifying
    from grader.run.schedule import default_jobs

    jobs = options.jobs or default_jobs()
    findings = verifying.verify(_root(options), jobs=jobs, only=options.only)
    return _findings([str(finding) for finding in findings], "the workbook is sound")


def _findings(findings: Sequence[str], praise: str) -> int:
    for finding in findings:
        print(finding)
    if not findings:
        print(praise)
    return FINDINGS if findings else OK
