"""The gradebook in a terminal: a table, and below it why checks did not pass."""

from __future__ import annotations

from typing import TYPE_CHECKING, TextIO

from grader.report.text import check_lines
from grader.report.words import ICONS, not_passed, number
from grader.results import ExerciseResult, Status
from grader.run.gradebook import Gradebook, StudentResult

if TYPE_CHECKING:
    from rich.console import Console

_COLUMNS = ("student", "exercise", "status", "points")
_COLOURS = {
    Status.PASSED: "green",
    Status.FAILED: "red",
    Status.ERROR: "red",
    Status.TIMEOUT: "yellow",
    Status.INFRASTRUCTURE: "magenta",
}


def print_gradebook(gradebook: Gradebook, stream: TextIO) -> None:
    """Print a gradebook: with colour and lines on a terminal, plain text elsewhere."""
    if stream.isatty():
        _print_rich(gradebook, stream)
    else:
        stream.write(_plain_table(gradebook))
    for entry in gradebook.submissions:
        for result in entry.exercises:
            stream.write("".join(f"{line}\n" for line in _reasons(entry, result)))
    stream.write(f"\nsandbox: {gradebook.sandbox}\n")


def _rows(gradebook: Gradebook) -> list[tuple[str, str, Status, str]]:
    return [
        (
            _one_line(entry.student),
            result.exercise_id,
            result.status,
            f"{number(result.points)} / {number(result.max_points)}",
        )
        for entry in gradebook.submissions
        for result in entry.exercises
    ]


def _plain_table(gradebook: Gradebook) -> str:
    rows = [_COLUMNS, *_rows(gradebook)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(_COLUMNS))]
    lines = [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]
    return "\n".join([lines[0], "  ".join("-" * width for width in widths), *lines[1:]]) + "\n"


def _print_rich(gradebook: Gradebook, stream: TextIO) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    console: Console = Console(file=stream)
    table = Table(*_COLUMNS)
    table.columns[-1].justify = "right"
    for student, exercise, status, points in _rows(gradebook):
        # As Text: a name with square brackets is a name, and no markup.
        word = Text(f"{ICONS[status]} {status.value}", style=_COLOURS.get(status, "dim"))
        table.add_row(Text(student), Text(exercise), word, Text(points))
    console.print(table)


def _reasons(entry: StudentResult, result: ExerciseResult) -> list[str]:
    checks = not_passed(result.checks)
    if not (checks or result.notes):
        return []
    lines = ["", f"{_one_line(entry.student)}, exercise {result.exercise_id}"]
    if len({(check.status, check.message) for check in result.checks}) == 1:
        # One reason for all of them, such as a notebook that cannot be read.
        lines += [f"  {line}" for line in checks[0].message.splitlines()] if checks else []
    else:
        lines += [line for check in checks for line in check_lines(check)]
    return [*lines, *(f"  note: {_one_line(note)}" for note in result.notes)]


def _one_line(text: str) -> str:
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())
