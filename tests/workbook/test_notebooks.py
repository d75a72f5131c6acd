"""Each notebook runs from top to bottom in a real kernel, in a work folder as students have it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from grader.authoring.start import start
from grader.exercises import Exercise

Run = Callable[[Path], list[Any]]


def started(course: Path, exercise: Exercise) -> Path:
    """The student's own copy of an exercise."""
    return start(course, exercise.id).notebook


def verdict(cells: list[Any]) -> str:
    """What the last cell, `check("...")`, shows where there is no HTML."""
    (output,) = cells[-1].outputs
    assert "text/html" in output.data
    return str(output.data["text/plain"])


def errors(cells: list[Any]) -> list[str]:
    """What any cell has said on standard error or as an error."""
    return [
        output.get("text") or output.get("evalue", "")
        for cell in cells
        for output in cell.get("outputs", [])
        if output.output_type == "error" or output.get("name") == "stderr"
    ]


def test_the_solution_passes_every_public_check(
    root: Path, course: Path, exercise: Exercise, run: Run
) -> None:
    mine = started(course, exercise)
    mine.write_bytes((root / "solutions" / mine.name).read_bytes())
    cells = run(mine)
    first, *checks = verdict(cells).splitlines()
    count = sum(line.startswith("  ✓ passed") for line in checks)
    assert count == len(checks) > 0
    assert f"public checks: {count} of {count} passed" in first
    assert errors(cells) == []


@pytest.mark.slow
def test_the_untouched_exercise_is_not_attempted(
    course: Path, exercise: Exercise, run: Run
) -> None:
    cells = run(started(course, exercise))
    first, *lines = verdict(cells).splitlines()
    assert ": 0 of " in first
    checks = [line for line in lines if line.endswith("]")]
    assert checks
    assert all(line.startswith("  ○ not attempted") for line in checks)
    assert errors(cells) == []
