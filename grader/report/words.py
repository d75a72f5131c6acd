"""The words and numbers that every report uses."""

from __future__ import annotations

from collections.abc import Sequence

from grader.results import CheckResult, ExerciseResult, Status

ICONS = {
    Status.PASSED: "✓",
    Status.FAILED: "✗",
    Status.NOT_ATTEMPTED: "○",
    Status.ERROR: "!",
    Status.TIMEOUT: "◷",
    Status.SKIPPED: "–",
    Status.INFRASTRUCTURE: "?",
}
"""One character for each status; the word always stands beside it."""


def number(points: float) -> str:
    """Points as people write them: 2, not 2.0; 0.5."""
    return f"{points:g}"


def of_points(points: float, max_points: float) -> str:
    """E.g. "2 of 3 points"."""
    unit = "point" if max_points == 1 else "points"
    return f"{number(points)} of {number(max_points)} {unit}"


def summary(result: ExerciseResult, *, hidden_to_come: bool) -> str:
    """One line about an exercise: "public checks: 2 of 3 passed, 4 of 6 points".

    Args:
        result: What came out.
        hidden_to_come: Whether only public checks ran, and hidden ones run at grading.
    """
    passed = sum(check.status is Status.PASSED for check in result.checks)
    what = "public checks" if hidden_to_come else "checks"
    points = of_points(result.points, result.max_points)
    line = f"{what}: {passed} of {len(result.checks)} passed, {points}"
    return f"{line}; hidden checks run when it is graded" if hidden_to_come else line


def explained(check: CheckResult) -> tuple[list[str], dict[str, str]]:
    """A check's message, taken apart: its sentences, and what was expected and got."""
    sentences: list[str] = []
    values: dict[str, str] = {}
    for line in check.message.splitlines():
        label, found, value = line.partition(": ")
        if found and label in ("expected", "got"):
            values[label] = value
        else:
            sentences.append(line)
    return sentences, values


def not_passed(checks: Sequence[CheckResult]) -> list[CheckResult]:
    """Those checks that did not pass, in their order."""
    return [check for check in checks if check.status is not Status.PASSED]
