"""A rule on namespaces that are declared and not used."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.wording import quoted

_DECLARES = "xmlns:"


@rule(
    "URDF-I48",
    "a namespace that nothing in the file uses",
    Severity.NOTE,
    both="It has no effect.",
)
def unused_namespace(sheet: Sheet) -> Iterator[Find]:
    """A namespace that nothing in the file uses.

    Symptom: None. It only makes the file look as if it were more than a URDF.

    Cause: A template, or the output of xacro, which leaves its declaration behind. In a file with macros it is needed; such a
    file goes through xacro before it is a URDF.

    Remedy: Leave it out.

    Wrong, without a macro in the file:

        <robot name="m2wr" xmlns:xacro="http://www.ros.org/wiki/xacro">

    Right:

        <robot name="m2wr">
    """
    declared = [] if sheet.robot is None else sheet.robot.attributes
    names = {
        one.name.removeprefix(_DECLARES): one for one in declared if one.name.startswith(_DECLARES)
    }
    if sheet.robot is None or not names:
        return
    for element in sheet.robot.walk():
        written = (element.name, *(one.name for one in element.attributes))
        for prefix in {name.partition(":")[0] for name in written if ":" in name}:
            names.pop(prefix, None)
    for prefix, attribute in names.items():
        yield Find(
            attribute.name_span,
            element=sheet.robot,
            what=f"the namespace {quoted(prefix)} is declared, and nothing in the file uses it",
            remedy=f"Leave out {shown(attribute.name)}.",
        )
