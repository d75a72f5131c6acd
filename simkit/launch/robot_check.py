"""What `check_urdf` says of a robot that a launch file puts on the parameter server, in short."""

from __future__ import annotations

from simkit.diagnostics import Diagnostic, Severity
from simkit.launch.budget import Budget
from simkit.launch.files import Files
from simkit.launch.plan import LaunchPlan
from simkit.packages import PackagePath
from simkit.xml import parse_xml

PARAMETER = "robot_description"
MAX_LINES = 8
"""So many finds are shown; check_urdf shows all."""


def robot_lines(plan: LaunchPlan, packages: PackagePath) -> dict[str, list[str]]:
    """One line for each error and warning, by the text of the robot.

    Args:
        plan: The launch file.
        packages: Where meshes are.
    """
    files = Files(packages, Budget())
    found: dict[str, list[str]] = {}
    for name, value in plan.params.items():
        if name.rpartition("/")[2] != PARAMETER or not isinstance(value, str):
            continue
        source = plan.origins[name].source
        file = name if source is None else files.shown(source)
        found[value] = _lines(value, file, packages, is_file=source is not None)
    return found


def _lines(text: str, file: str, packages: PackagePath, *, is_file: bool) -> list[str]:
    from simkit.urdf.rules import check_robot

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
