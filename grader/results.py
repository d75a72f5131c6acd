"""What checking gives: one result per check, and one per exercise, as values and as JSON.

The status of an exercise follows from its checks; the first rule that fits counts:

1. no check, or a check with `infrastructure`: `infrastructure` (our fault, never the student's);
2. all passed: `passed`;
3. all skipped: `skipped`;
4. all not attempted or skipped: `not attempted`;
5. a check with `timeout`: `timeout`;
6. a check with `error`: `error`;
7. else: `failed`.

Its points are the sum of its checks' points. Only `passed` (all of them) and `failed` (partial
credit) carry points.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, fields
from enum import StrEnum
from typing import Self

from grader.errors import ResultError

MAX_NAME = 200
"""Longest name or id [characters]."""
MAX_TEXT = 4000
"""Longest title, message, hint or note [characters]; a longer one is cut when it is made."""
MAX_CHECKS = 500
"""Most checks of one exercise."""
MAX_NOTES = 100
"""Most notes of one exercise."""
MAX_POINTS = 10_000.0
"""Most points of one check."""
MAX_RESULT_BYTES = 16_000_000
"""Longest JSON text of one result."""


class Status(StrEnum):
    """How a check or an exercise came out."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_ATTEMPTED = "not attempted"
    ERROR = "error"
    TIMEOUT = "timeout"
    SKIPPED = "skipped"
    INFRASTRUCTURE = "infrastructure"


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckResult:
    """The verdict of one check."""

    name: str
    """The check's function, e.g. "test_frame_follows_the_turtle"."""
    title: str
    """The sentence the student sees."""
    status: Status
    points: float = 0.0
    """Points earned, from 0 to `max_points`."""
    max_points: float = 0.0
    hidden: bool = False
    """Whether the check runs at grading only."""
    message: str = ""
    """Why it did not pass, for the student."""
    hint: str = ""
    """What to try next."""
    log: str = ""
    """Errors and warnings of the check's simulation, a line each; for authors, empty when a class is graded."""

    def __post_init__(self) -> None:
        for name in ("title", "message", "hint", "log"):
            object.__setattr__(self, name, _bounded(getattr(self, name)))
        object.__setattr__(self, "name", _bounded(self.name, MAX_NAME))
        _require_points(self)

    def to_json(self) -> dict[str, object]:
        """The result as plain values, in the shape of the gradebook."""
        values = {**asdict(self), "status": str(self.status)}
        return values if self.log else {key: values[key] for key in values if key != "log"}

    @classmethod
    def from_json(cls, value: object) -> Self:
        """The result that `to_json` wrote.

        Raises:
            ResultError: Anything else: other keys, other types, out of bounds.
        """
        given = {"log": "", **value} if isinstance(value, dict) else value
        record = _record(given, [f.name for f in fields(cls)], "check")
        return cls(
            name=_text(record, "name", MAX_NAME),
            title=_text(record, "title"),
            status=_status(record),
            points=_number(record, "points"),
            max_points=_number(record, "max_points"),
            hidden=_flag(record, "hidden"),
            message=_text(record, "message"),
            hint=_text(record, "hint"),
            log=_text(record, "log"),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class ExerciseResult:
    """The verdict of one exercise of one submission."""

    exercise_id: str
    """E.g. "3.1"."""
    status: Status
    points: float
    max_points: float
    checks: tuple[CheckResult, ...]
    """In the order of the files of checks."""
    notes: tuple[str, ...] = ()
    """Sentences for the student about how the hand-in was read."""

    @classmethod
    def from_checks(
        cls, exercise_id: str, checks: Iterable[CheckResult], *, notes: Sequence[str] = ()
    ) -> Self:
        """The result that follows from the checks (rules: see the module)."""
        checks = tuple(checks)
        return cls(
            exercise_id=exercise_id,
            status=status_of(checks),
            points=math.fsum(check.points for check in checks),
            max_points=math.fsum(check.max_points for check in checks),
            checks=checks,
            notes=tuple(_bounded(note) for note in notes[:MAX_NOTES]),
        )

    @classmethod
    def without_checks(
        cls,
        exercise_id: str,
        status: Status,
        *,
        message: str,
        hint: str = "",
        max_points: float = 0.0,
    ) -> Self:
        """The verdict when no check could run, e.g. since the notebook cannot be read."""
        return cls.from_checks(
            exercise_id,
            [
                CheckResult(
                    name="submission",
                    title="The submission can be graded.",
                    status=status,
                    max_points=max_points,
                    message=message,
                    hint=hint,
                )
            ],
        )

    def to_json(self) -> dict[str, object]:
        """The result as plain values."""
        return {
            "exercise_id": self.exercise_id,
            "status": str(self.status),
            "points": self.points,
            "max_points": self.max_points,
            "checks": [check.to_json() for check in self.checks],
            "notes": list(self.notes),
        }

    @classmethod
    def from_json(cls, value: object) -> Self:
        """The result that `to_json` wrote.

        Raises:
            ResultError: Anything else, also a status or points that its checks do not give.
        """
        record = _record(value, [f.name for f in fields(cls)], "result")
        checks = [CheckResult.from_json(item) for item in _list(record, "checks", MAX_CHECKS)]
        notes = [_require_text(note, "note") for note in _list(record, "notes", MAX_NOTES)]
        result = cls.from_checks(_text(record, "exercise_id", MAX_NAME), checks, notes=notes)
        if any(isinstance(record[key], bool) for key in ("points", "max_points")) or (
            result.to_json() != record
        ):
            raise ResultError("status or points of the result do not follow from its checks")
        return result

    def dumps(self) -> str:
        """The result as one line of JSON text (ASCII)."""
        return json.dumps(self.to_json(), sort_keys=True, allow_nan=False)

    @classmethod
    def loads(cls, text: str | bytes) -> Self:
        """The result that `dumps` wrote.

        Raises:
            ResultError: Anything else.
        """
        if len(text) > MAX_RESULT_BYTES:
            raise ResultError(f"the result is longer than {MAX_RESULT_BYTES} bytes")
        try:
            value = json.loads(text)
        except (ValueError, RecursionError) as error:
            raise ResultError(f"the result is not JSON: {error}") from error
        return cls.from_json(value)


def status_of(checks: Sequence[CheckResult]) -> Status:
    """The status of an exercise with these checks (rules: see the module)."""
    found = {check.status for check in checks}
    if not found or Status.INFRASTRUCTURE in found:
        return Status.INFRASTRUCTURE
    if len(found) == 1:
        return found.pop()
    if found == {Status.NOT_ATTEMPTED, Status.SKIPPED}:
        return Status.NOT_ATTEMPTED
    for status in (Status.TIMEOUT, Status.ERROR):
        if status in found:
            return status
    return Status.FAILED


def _bounded(text: str, limit: int = MAX_TEXT) -> str:
    # Lone surrogates (a student's output may hold them) can be neither stored nor printed.
    text = text.encode("utf-8", "replace").decode("utf-8")
    if len(text) <= limit:
        return text
    ending = " ... (shortened)"
    return text[: limit - len(ending)] + ending


def _require_points(check: CheckResult) -> None:
    points, most = check.points, check.max_points
    if not (math.isfinite(most) and 0 <= most <= MAX_POINTS and 0 <= points <= most):
        raise ResultError(f"{check.name}: {points} of {most} points is impossible")
    if check.status is Status.PASSED and points != most:
        raise ResultError(f"{check.name}: passed with {points} of {most} points")
    if points and check.status not in (Status.PASSED, Status.FAILED):
        raise ResultError(f"{check.name}: {check.status} with {points} points")


def _record(value: object, keys: Sequence[str], what: str) -> dict[str, object]:
    if not isinstance(value, dict) or set(value) != set(keys):
        raise ResultError(f"a {what} has exactly the keys {', '.join(keys)}")
    return value


def _require_text(value: object, what: str, limit: int = MAX_TEXT) -> str:
    if not isinstance(value, str) or len(value) > limit:
        raise ResultError(f"{what} must be a text of at most {limit} characters")
    return value


def _text(record: dict[str, object], key: str, limit: int = MAX_TEXT) -> str:
    return _require_text(record[key], key, limit)


def _number(record: dict[str, object], key: str) -> float:
    value = record[key]
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise ResultError(f"{key} must be a number")
    if not 0 <= value <= MAX_POINTS:
        raise ResultError(f"{key} must lie between 0 and {MAX_POINTS}")
    return float(value)


def _flag(record: dict[str, object], key: str) -> bool:
    value = record[key]
    if not isinstance(value, bool):
        raise ResultError(f"{key} must be true or false")
    return value


def _list(record: dict[str, object], key: str, limit: int) -> list[object]:
    value = record[key]
    if not isinstance(value, list) or len(value) > limit:
        raise ResultError(f"{key} must be a list of at most {limit}")
    return value


def _status(record: dict[str, object]) -> Status:
    value = record["status"]
    if not isinstance(value, str) or value not in {str(status) for status in Status}:
        raise ResultError(f"status must be one of {', '.join(Status)}")
    return Status(value)
