"""Exercises graded with all their checks; one of them against nbclient that only runs the same notebook."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nbformat
from figures import Figure, median_of, show
from nbclient import NotebookClient

from grader.exercises import find_root, get_exercise, load_exercises
from grader.run import grade_submission
from grader.sandbox import Sandbox, find_sandbox
from grader.submission import submission_from_notebook

RUNS = 5
EXERCISE = "3.1"


def seconds(work: Callable[[], object]) -> float:
    """Median wall time of a few runs [s]; the first one, which warms caches up, is left out."""
    durations = []
    for _ in range(RUNS + 1):
        start = time.perf_counter()
        work()
        durations.append(time.perf_counter() - start)
    return median_of(durations[1:])


def grading(root: Path, sandbox: Sandbox, name: str = EXERCISE) -> Callable[[], object]:
    """Grades the solution of an exercise, hidden checks too."""
    exercise = get_exercise(root, name)
    notebook = root / "solutions" / f"{exercise.slug}.ipynb"

    def grade() -> None:
        submission = submission_from_notebook(notebook, exercise)
        result = grade_submission(submission, exercise, hidden=True, sandbox=sandbox)
        assert result.points == result.max_points, result

    return grade


def bare_run(notebook: Path, package: str) -> Callable[[], object]:
    """Runs the notebook in a kernel, without its last cell, which would grade."""
    loaded: Any = nbformat.read(notebook, as_version=4)
    loaded.cells = [cell for cell in loaded.cells if 'check("' not in cell.source]

    def run() -> None:
        with tempfile.TemporaryDirectory() as folder:
            scripts = Path(folder) / package / "scripts"
            scripts.mkdir(parents=True)
            (scripts.parent / "package.xml").write_text(
                f"<package><name>{package}</name></package>"
            )
            place = {"metadata": {"path": folder}}
            NotebookClient(
                loaded, resources=place, timeout=60, extra_arguments=["--log-level=ERROR"]
            ).execute()

    return run


def main() -> None:
    """Print the figures."""
    root = find_root(Path(__file__).parent)
    exercise = get_exercise(root, EXERCISE)
    strongest = find_sandbox()
    plain = seconds(grading(root, Sandbox(name="none")))
    sandboxed = seconds(grading(root, strongest))
    bare = seconds(bare_run(root / "solutions" / f"{exercise.slug}.ipynb", exercise.package))
    show(
        Figure(f"exercise {EXERCISE} graded, plain process", plain, "s", 3.0),
        Figure(f"exercise {EXERCISE} graded, sandbox: {strongest.name}", sandboxed, "s", 3.0),
        Figure("the same notebook only run, nbclient", bare, "s"),
        Figure("graded in the sandbox over only run", sandboxed / bare, "x"),
    )
    for name in load_exercises(root):
        took = seconds(grading(root, strongest, name))
        show(Figure(f"exercise {name} graded, all checks and the start", took, "s", 3.0))


if __name__ == "__main__":
    main()
