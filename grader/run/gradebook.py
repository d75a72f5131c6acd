"""`gradebook.json`: what came out, for other programs; the same bytes for the same results."""

from __future__ import annotations

import json
import os
import tempfile
from dataclasses import dataclass
from pathlib import Path

from grader.errors import GraderError
from grader.results import ExerciseResult

VERSION = 1
"""Version of the schema; it changes when a key goes or changes its meaning."""


@dataclass(frozen=True, slots=True, kw_only=True)
class StudentResult:
    """All that one student handed in."""

    student: str
    exercises: tuple[ExerciseResult, ...]
    """In the order of the workbook."""

    @property
    def points(self) -> float:
        """Points earned."""
        return sum(result.points for result in self.exercises)

    @property
    def max_points(self) -> float:
        """Points that could be earned."""
        return sum(result.max_points for result in self.exercises)


@dataclass(frozen=True, slots=True, kw_only=True)
class Gradebook:
    """The results of a class."""

    sandbox: str
    """Name of the isolation: "bubblewrap" or "none"."""
    submissions: tuple[StudentResult, ...]
    """By name of the student."""

    def to_json(self) -> dict[str, object]:
        """The gradebook in its versioned schema."""
        return {
            "version": VERSION,
            "sandbox": self.sandbox,
            "submissions": [_student(entry) for entry in self.submissions],
        }


def _student(entry: StudentResult) -> dict[str, object]:
    return {
        "student": entry.student,
        "points": entry.points,
        "max_points": entry.max_points,
        "exercises": [_exercise(result) for result in entry.exercises],
    }


def _exercise(result: ExerciseResult) -> dict[str, object]:
    return {
        "id": result.exercise_id,
        "status": str(result.status),
        "points": result.points,
        "max_points": result.max_points,
        "checks": [check.to_json() for check in result.checks],
    }


def write_gradebook(gradebook: Gradebook, path: Path) -> None:
    """Write a gradebook; whatever happens, the file is the old one or the new one, whole.

    Raises:
        GraderError: The disk is full, or the folder cannot be written to.
    """
    text = json.dumps(gradebook.to_json(), indent=2, ensure_ascii=False, allow_nan=False) + "\n"
    temporary = ""
    try:
        descriptor, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}-")
        with os.fdopen(descriptor, "w", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        Path(temporary).chmod(0o644)
        os.replace(temporary, path)  # noqa: PTH105 (the atomic one, on every system)
    except OSError as error:
        if temporary:
            Path(temporary).unlink(missing_ok=True)
        raise GraderError(f"{path} cannot be written: {error.strerror}") from error
