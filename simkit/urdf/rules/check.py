"""Runs the rules over a file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.diagnostics import Diagnostic, Rule, Severity, in_order
from simkit.record import replace
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
    return in_order(one for rule in rules_for(sheet) for one in _told(_looked(rule, sheet)))


def _looked(rule: Rule, sheet: Sheet) -> Iterable[Diagnostic]:
    try:
        return list(rule.look(sheet))
    except Exception as error:  # a fault of ours must not hide what the other rules find
        what = f"the rule {rule.id} could not be applied: {type(error).__name__}: {error}"
        remedy = "This is a fault of simkit, not of your file; please report it with the file."
        return [sheet.find(rule.id, Severity.NOTE, Span(1, 1), what=what, remedy=remedy)]


def _told(found: Iterable[Diagnostic]) -> Iterable[Diagnostic]:
    """The first finds of each kind (what is wrong, and in which kind of element), and a number for the rest."""
    kinds: dict[tuple[str, str], list[Diagnostic]] = {}
    for one in found:
        kinds.setdefault((one.file, _element_name(one.path)), []).append(one)
    for same in kinds.values():
        yield from same[: MOST_FINDS - 1]
        rest = same[MOST_FINDS - 1 :]
        if len(rest) == 1:
            yield rest[0]
        elif rest:
            yield replace(rest[0], what=f"{rest[0].what}; and {len(rest) - 1} more like it")


def _element_name(path: str) -> str:
    return re.sub(r"\[[^]]*\]", "", path).rpartition("/")[2]
