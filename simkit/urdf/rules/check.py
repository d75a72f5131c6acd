"""Runs the rules over a file."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.diagnostics import Diagnostic, Find, Rule, Severity, in_order
from simkit.urdf.rules.companion import Companion
from simkit.urdf.rules.registry import rules_for
from simkit.urdf.rules.sheet import MOST_FINDS, Sheet, read_sheet
from simkit.xml import Document, Span

if TYPE_CHECKING:
    from simkit.packages import PackagePath


def check_robot(
    document: Document,
    *,
    packages: PackagePath | None = None,
    companions: Sequence[Companion] = (),
    folder: Path | None = None,
) -> tuple[Diagnostic, ...]:
    """All that the rules find in a URDF; never raises.

    Args:
        document: The URDF.
        packages: Where `package://` leads; with None meshes are not looked for.
        companions: Launch and YAML files beside it, which must fit it.
        folder: Where relative names of meshes begin; the folder of the document's file if None.

    Returns:
        The finds by place, at most 20 of a kind, and then how many more there are.
    """
    sheet = read_sheet(document, packages=packages, companions=companions, folder=folder)
    return in_order(one for rule in rules_for(sheet) for one in _found(rule, sheet))


def _found(rule: Rule, sheet: Sheet) -> Iterator[Diagnostic]:
    """The first finds of each kind (what is wrong, and in which kind of element), and a number for the rest."""
    kinds: dict[tuple[str, str], list[Find]] = {}
    for one in _looked(rule, sheet):
        file = (one.companion or sheet.document).file
        kinds.setdefault((file, "" if one.about is None else one.about.name), []).append(one)
    for same in kinds.values():
        told, rest = same[:MOST_FINDS], len(same) - MOST_FINDS
        if rest > 0:
            told[-1] = replace(told[-1], what=f"{told[-1].what}; and {rest} more like it")
        yield from (rule.diagnostic(one, sheet.document) for one in told)


def _looked(rule: Rule, sheet: Sheet) -> Iterable[Find]:
    try:
        return [] if rule.look is None else list(rule.look(sheet))
    except Exception as error:  # a fault of ours must not hide what the other rules find
        what = f"the rule {rule.id} could not be applied: {type(error).__name__}: {error}"
        remedy = "This is a fault of simkit, not of your file; please report it with the file."
        return [Find(Span(1, 1), what=what, remedy=remedy, severity=Severity.NOTE)]
