"""Results that are already known, in SQLite: a run that was stopped goes on where it was."""

from __future__ import annotations

import functools
import hashlib
import json
import sqlite3
import sys
from importlib import metadata
from pathlib import Path

import grader
import simkit
from grader.errors import GraderError
from grader.exercises import Exercise
from grader.results import ExerciseResult
from grader.sandbox import Sandbox
from grader.submission import Submission

_SCHEMA = """
create table if not exists result (
    key text primary key,
    student text not null,
    exercise text not null,
    body text not null
) without rowid
"""
_BUSY_SECONDS = 60.0
_PACKAGES = ("simkit-workbook", "numpy", "pytest")


class ResultStore:
    """Results by key; each is one transaction, so that nothing but the last one can be lost.

    Args:
        path: Database file; made if it is not there.
    """

    def __init__(self, path: Path) -> None:
        try:
            self._connection = sqlite3.connect(path, timeout=_BUSY_SECONDS, isolation_level=None)
            self._connection.execute("pragma journal_mode = wal")
            self._connection.execute(_SCHEMA)
        except sqlite3.Error as error:
            raise GraderError(f"{path} cannot be used as a gradebook: {error}") from error

    def get(self, key: str) -> ExerciseResult | None:
        """The result that was stored under a key."""
        row = self._connection.execute("select body from result where key = ?", (key,)).fetchone()
        return ExerciseResult.loads(row[0]) if row is not None else None

    def put(self, key: str, *, student: str, result: ExerciseResult) -> None:
        """Store a result; an earlier one of the same key is replaced."""
        values = (key, student, result.exercise_id, result.dumps())
        self._connection.execute("insert or replace into result values (?, ?, ?, ?)", values)

    def close(self) -> None:
        """Close the database."""
        self._connection.close()


def result_key(
    submission: Submission, exercise: Exercise, *, hidden: bool, sandbox: Sandbox
) -> str:
    """What a result depends on, as one short text: equal keys, equal results.

    Args:
        submission: What was handed in.
        exercise: What was asked for; the content of its check files and of their oracles counts.
        hidden: Whether the hidden checks run too.
        sandbox: Where nodes run; its name counts.
    """
    parts = [
        submission.student,
        exercise.id,
        sorted(submission.files.items()),
        submission.answers,
        list(submission.notes),
        exercise.package,
        list(exercise.files),
        list(exercise.answers),
        [list(names) for names in _permissions(exercise)],
        sorted(exercise.stub_files.items()),
        _hash(exercise.public_checks),
        [_hash(path) for path in exercise.oracles],
        _hash(exercise.hidden_checks) if hidden else None,
        sandbox.name,
        _versions(),
    ]
    text = json.dumps(parts, sort_keys=True, ensure_ascii=True)
    return hashlib.sha256(text.encode()).hexdigest()


def _permissions(exercise: Exercise) -> tuple[tuple[str, ...], ...]:
    may = exercise.permissions
    return (may.publish, may.services, may.parameters)


def _hash(path: Path | None) -> str | None:
    return hashlib.sha256(path.read_bytes()).hexdigest() if path and path.is_file() else None


@functools.cache
def _versions() -> list[str]:
    """Versions of what grades, and the content of our own code: a clone has no new version."""
    versions = [f"python {sys.version_info.major}.{sys.version_info.minor}"]
    for name in _PACKAGES:
        try:
            versions.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            versions.append(f"{name} -")
    return [*versions, _hash_code()]


def _hash_code() -> str:
    digest = hashlib.sha256()
    for package in (simkit, grader):
        assert package.__file__ is not None
        folder = Path(package.__file__).parent
        for path in sorted(folder.rglob("*.py")):
            digest.update(f"{path.relative_to(folder.parent).as_posix()}\0".encode())
            digest.update(path.read_bytes())
    return digest.hexdigest()
