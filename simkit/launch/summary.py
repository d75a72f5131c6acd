"""The summary that roslaunch prints before it starts anything, and its warnings.

Source: roslaunch `ROSLaunchConfig.summary`: sorted lines, long values cut, nodes by namespace.
"""

from __future__ import annotations

from typing import Any

from simkit.diagnostics import Severity
from simkit.launch.plan import LaunchPlan

_LONGEST = 20


def summary_of(plan: LaunchPlan) -> str:
    """Parameters and nodes of a launch file, as roslaunch lists them."""
    text = "SUMMARY\n========"
    if plan.clear_params:
        text += "\n\nCLEAR PARAMETERS\n" + _lines(f" * {name}" for name in plan.clear_params)
    if plan.params:
        values = (f" * {name}: {_short(value)}" for name, value in plan.params.items())
        text += "\n\nPARAMETERS\n" + _lines(values)
    text += "\n\nNODES\n"
    by_namespace: dict[str, list[str]] = {}
    for node in plan.nodes:
        line = f"    {node.name} ({node.package}/{node.type})"
        by_namespace.setdefault(node.namespace, []).append(line)
    for namespace, nodes in by_namespace.items():
        text += f"  {namespace}\n{_lines(nodes)}\n"
    return text


def _lines(lines: Any) -> str:
    return "\n".join(sorted(lines))


def _short(value: Any) -> str:
    text = str(value)
    if len(text) > _LONGEST:
        text = text[: _LONGEST - 3] + "..."
    return text if all(32 <= ord(letter) <= 126 for letter in text) else "<...>"


def warning_lines(plan: LaunchPlan) -> list[str]:
    """What roslaunch warns of in a launch file, and the place and remedy of each."""
    return [
        *plan.warnings,
        *(
            f"{one.file}:{one.span.line}:{one.span.column}: {one.severity.value} [{one.rule}] "
            f"{one.what}. {one.remedy}"
            for one in plan.diagnostics
            if one.severity is not Severity.NOTE
        ),
    ]
