"""Results as plain lines: in a terminal, in a log, and as the notebook's fallback."""

from __future__ import annotations

from grader.report.words import ICONS, number, summary
from grader.results import CheckResult, ExerciseResult

_INDENT = " " * 19


def exercise_text(result: ExerciseResult, *, title: str = "", hidden_to_come: bool = False) -> str:
    """One exercise: a line that sums it up, then a line for each check and why it did not pass.

    Args:
        result: What came out.
        title: Title of the exercise.
        hidden_to_come: Whether only public checks ran, and hidden ones run at grading.
    """
    name = f"Exercise {result.exercise_id}" + (f" ({title})" if title else "")
    lines = [f"{name}: {summary(result, hidden_to_come=hidden_to_come)}"]
    lines += [line for check in result.checks for line in check_lines(check)]
    lines += [f"  note: {note}" for note in result.notes]
    return "\n".join(lines)


def check_lines(check: CheckResult) -> list[str]:
    """One check: status, sentence and points; below, its message and hint."""
    icon = ICONS[check.status]
    points = f"{number(check.points)}/{number(check.max_points)}"
    lines = [f"  {icon} {check.status.value:<15}{check.title}  [{points}]"]
    lines += [f"{_INDENT}{line}" for line in check.message.splitlines()]
    if check.hint:
        lines += [f"{_INDENT}hint: {check.hint}"]
    return lines
