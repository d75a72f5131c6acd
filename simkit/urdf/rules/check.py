"""Runs the rules over a file.

A rule is a generator that is decorated with its row of the table, in the module of its subject. A row has a stable id: `URDF-`
(what is written), `GZ-`, `CTL-` (what the simulation makes of it) and their kin; E, W or I for the worst that it reports (error,
warning, note); and a number that is never used again.

A subject is loaded when a file has what it looks at, so that the answer for a small robot comes soon.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from simkit.diagnostics import Diagnostic, Find, Rule, Severity, in_order
from simkit.diagnostics.table import in_table_order, rules_in
from simkit.urdf.model import Mesh
from simkit.urdf.rules.sheet import MOST_FINDS, Companion, Sheet, read_sheet
from simkit.xml import Document, FaultKind, Span

if TYPE_CHECKING:
    from simkit.packages import PackagePath
    from simkit.urdf.reading import Reading


def rules_for(sheet: Sheet) -> tuple[Rule, ...]:
    """The rules that can find something in a file."""
    return _rules_of(subject for subject, has_matter in _SUBJECTS.items() if has_matter(sheet))


@cache
def all_rules() -> tuple[Rule, ...]:
    """All rules, by id within their group."""
    return in_table_order(_rules_of(_SUBJECTS))


def _rules_of(subjects: Iterable[str]) -> tuple[Rule, ...]:
    modules = [importlib.import_module(f"{__package__}.{subject}") for subject in subjects]
    return tuple(rule for module in modules for rule in rules_in(module))


def _has_meshes(sheet: Sheet) -> bool:
    bodies = (body for link in sheet.links for body in (*link.visuals, *link.collisions))
    return any(isinstance(body.shape, Mesh) for body in bodies)


def _has_bodies(sheet: Sheet) -> bool:
    """Whether any link has mass, or can be touched: a robot to simulate, not only to look at."""
    return any(link.inertial is not None or link.collisions for link in sheet.links)


def _has_drive(sheet: Sheet) -> bool:
    return any("drive" in (plugin.filename or "") for plugin in sheet.plugins)


_SUBJECTS: Mapping[str, Callable[[Sheet], object]] = {
    "document": lambda _: True,
    **dict.fromkeys(
        ("tree", "names", "parts", "words", "numbers", "angles", "mass"),
        lambda sheet: sheet.robot is not None,
    ),
    **dict.fromkeys(("limits", "joints"), lambda sheet: sheet.joints),
    "materials": lambda sheet: sheet.materials,
    "meshes": _has_meshes,
    **dict.fromkeys(("inertia", "shape_inertia", "shape_places", "spawn"), _has_bodies),
    **dict.fromkeys(("gazebo_blocks", "colours"), lambda sheet: sheet.gazebo or _has_bodies(sheet)),
    "sensors": lambda sheet: sheet.gazebo,
    **dict.fromkeys(("plugins", "plugin_joints"), lambda sheet: sheet.plugins),
    "drive": _has_drive,
    "transmissions": lambda sheet: sheet.plugins or sheet.transmissions or sheet.companions,
    **dict.fromkeys(("controllers", "launch_files"), lambda sheet: sheet.companions),
}
"""Modules of this folder that have rules, each with what a file must have for them to find anything."""


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
    found = [one for rule in rules_for(sheet) for one in _found(rule, sheet)]
    lost = [fault.span for fault in document.faults if fault.kind is FaultKind.STRAY_END]
    return in_order(one for one in found if not any(_is_within(one, tag) for tag in lost))


def _is_within(find: Diagnostic, end_tag: Span) -> bool:
    """Whether a find is about an element of which only the end tag is there; the fault of that tag says all."""
    column = find.span.column - end_tag.column
    return find.span.line == end_tag.line and 0 < column < end_tag.length


def _found(rule: Rule, sheet: Sheet) -> Iterator[Diagnostic]:
    """The first finds of each kind (what is wrong, and in which kind of element), and a number for the rest."""
    kinds: dict[tuple[str, str], list[Find]] = {}
    for one in _looked(rule, sheet):
        file = (one.companion or sheet.document).file
        kinds.setdefault((file, "" if one.about is None else one.about.name), []).append(one)
    for same in kinds.values():
        shown, rest = same[:MOST_FINDS], len(same) - MOST_FINDS
        if rest > 0:
            shown[-1] = replace(shown[-1], what=f"{shown[-1].what}; and {rest} more like it")
        yield from (rule.diagnostic(one, sheet.document) for one in shown)


def _looked(rule: Rule, sheet: Sheet) -> Iterable[Find]:
    try:
        return [] if rule.look is None else list(rule.look(sheet))
    except Exception as error:  # a fault of ours must not hide what the other rules find
        what = f"the rule {rule.id} could not be applied: {type(error).__name__}: {error}"
        remedy = "This is a fault of simkit, not of your file; please report it with the file."
        return [Find(Span(1, 1), what=what, remedy=remedy, severity=Severity.NOTE)]


MAX_LINES = 8
"""So many finds are shown; check_urdf shows all."""


def brief_lines(reading: Reading, *, is_file: bool) -> list[str]:
    """What the rules say of a robot, in short: a line for each error and warning, and how to learn more.

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
