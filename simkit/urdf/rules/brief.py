"""What the rules say of a robot that is loaded or spawned, in short: `check_urdf` says more."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Severity
from simkit.packages import PackagePath
from simkit.urdf.rules.check import check_robot
from simkit.xml import parse_xml

MAX_LINES = 8
"""So many finds are shown; check_urdf shows all."""


def brief_lines(text: str, file: str, packages: PackagePath, *, is_file: bool) -> list[str]:
    """One line for each error and warning, and how to learn more.

    Args:
        text: The URDF.
        file: Name to show for it.
        packages: Where meshes are.
        is_file: Whether it is a file that check_urdf can be given.
    """
    document = parse_xml(text, file=file)
    finds = [
        one for one in check_robot(document, packages=packages) if one.severity is not Severity.NOTE
    ]
    lines = [_line(one) for one in finds[:MAX_LINES]]
    if finds:
        more = f"{len(finds) - MAX_LINES} more; " if len(finds) > MAX_LINES else ""
        how = f"simkit check_urdf {file} says more" if is_file else "check_urdf says more"
        lines.append(f"{more}{how}")
    return lines


def _line(find: Diagnostic) -> str:
    place = f"{find.file}:{find.span.line}:{find.span.column}"
    return f"{place}: {find.severity.value} [{find.rule}] {find.what}"
