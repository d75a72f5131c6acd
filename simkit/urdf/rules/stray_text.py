"""The rule about text where URDF has none."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.grammar import in_context
from simkit.urdf.rules.missing import missing_attributes
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.wording import called, part_of


@rule(
    "URDF-I36",
    "text where URDF has none",
    Severity.NOTE,
    both="It is not read.",
)
def stray_text(sheet: Sheet) -> Iterator[Find]:
    """Text between the tags, where URDF has none.

    Nobody reads it. Mostly a `>` was typed twice, or a comment was written without `<!--` and `-->`. In `<gazebo>` and
    `<transmission>` text does count.

    Wrong:

        <geometry>
          <box size="1 1 1"/>
        </geometry>>

    Right:

        <geometry>
          <box size="1 1 1"/>
        </geometry>
    """
    if sheet.robot is None:
        return
    for element, word in in_context(sheet.robot):
        text = element.text.strip()
        if not text or element.text_span is None or missing_attributes(element, word):
            continue
        is_tag = text == ">"
        where = called(element) if element.parent is None else part_of(element)
        yield Find(
            element.text_span,
            element=element,
            what=f"the text {shown(text)!r} in {where} says nothing to URDF",
            remedy="Take the second > out."
            if is_tag
            else "Take it out, or make it a comment: <!-- ... -->.",
        )
