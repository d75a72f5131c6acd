"""What the rules say of a robot that is loaded or spawned, in short: `check_urdf` says more."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Severity
from simkit.urdf.reading import Reading

MAX_LINES = 8
"""So many finds are shown; check_urdf shows all."""


def brief_lines(reading: Reading, *, is_file: bool) -> list[str]:
    """One line for each error and warning, and how to learn more.

    Args:
        reading: The robot.
        is_file: Whether it is a file that check_urdf can be given.
    """
    file = reading.document.file
    finds = [one for one in reading.diagnostics if one.severity is not Severity.NOTE]
    lines = [_line(one) for one in finds[:MAX_LINES]]
    if finds:
        more = f"{len(finds) - MAX_LINES} more; " if len(finds) > MAX_LINES else ""
        how = f"simkit check_urdf {file} says more" if is_file else "check_urdf says more"
        lines.append(f"{more}{how}")
    return lines


def _line(find: Diagnostic) -> str:
    place = f"{find.file}:{find.span.line}:{find.span.column}"
    return f"{place}: {find.severity.value} [{find.rule}] {find.what}"
