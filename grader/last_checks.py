"""How far a student is: the points of the last check of each exercise, as the working folder remembers them."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from grader.exercises import Exercise, find_root, load_exercises
from grader.results import ExerciseResult, Status

RECORD = ".checked.json"
"""File in the working folder: the points of the last check of each exercise."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """What is known of one exercise."""

    exercise: Exercise
    text: str
    """How far it is: "7 of 8 points", "not checked yet"."""
    passed: bool = False
    """Whether its public checks passed when they ran last."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Progress:
    """What `progress` returns: a table."""

    rows: tuple[Row, ...]

    def _repr_markdown_(self) -> str:
        lines = ["| exercise | last check |", "|:---|:---|"]
        for row in self.rows:
            sign = "✓ " if row.passed else ""
            link = f"[{row.exercise.id} {row.exercise.title}]({row.exercise.slug}.ipynb)"
            lines.append(f"| {link} | {sign}{row.text} |")
        return "\n".join(lines)

    def __repr__(self) -> str:
        """The lines for a terminal."""
        return "\n".join(f"{row.exercise.id:<5} {row.text}" for row in self.rows)


def progress() -> Progress:
    """The points of the last `check` of each exercise: of the public checks, in this working folder."""
    folder = Path.cwd()
    root = find_root(folder)
    work = folder if (folder / RECORD).exists() else root / "work"
    return progress_of(work, load_exercises(root).values())


def progress_of(work: Path, exercises: Iterable[Exercise]) -> Progress:
    """The points of the last check of each of some exercises.

    Args:
        work: The working folder.
        exercises: In the order of the table.
    """
    record = _read(work)
    return Progress(rows=tuple(_row(one, record.get(one.id)) for one in exercises))


def remember(work: Path, result: ExerciseResult) -> None:
    """Keep the points of a check; a folder that cannot be written remembers nothing.

    Args:
        work: The working folder.
        result: What its public checks gave.
    """
    points = {"points": result.points, "of": result.max_points, "status": result.status.value}
    record = _read(work) | {result.exercise_id: points}
    with contextlib.suppress(OSError):
        (work / RECORD).write_text(json.dumps(record, indent=1, sort_keys=True), encoding="utf-8")


def _row(exercise: Exercise, known: Any) -> Row:
    try:
        points, of, status = float(known["points"]), float(known["of"]), Status(known["status"])
    except (KeyError, TypeError, ValueError):
        return Row(exercise=exercise, text="not checked yet")
    if status is Status.NOT_ATTEMPTED:
        return Row(exercise=exercise, text="not begun")
    text = f"{points:g} of {of:g} points"
    return Row(exercise=exercise, text=text, passed=status is Status.PASSED)


def _read(work: Path) -> dict[str, Any]:
    try:
        record = json.loads((work / RECORD).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return record if isinstance(record, dict) else {}
