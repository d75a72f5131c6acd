"""The rule about the type of a joint."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.meaning import nearest
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.vocabulary import JOINT_TYPES
from simkit.urdf.rules.wording import REFUSED, called

_OTHER_NAMES = {
    **dict.fromkeys(("hinge", "rotational", "rotary", "rotation", "rotate", "pivot"), "revolute"),
    **dict.fromkeys(("slider", "linear", "translational", "slide", "prism"), "prismatic"),
    **dict.fromkeys(("rigid", "weld", "static", "none", "fix"), "fixed"),
    **dict.fromkeys(("wheel", "endless", "spin"), "continuous"),
    **dict.fromkeys(("free", "6dof"), "floating"),
}
_NOT_THERE = {
    **dict.fromkeys(
        ("ball", "spherical"), "three revolute joints about x, y, z with small links between them"
    ),
    **dict.fromkeys(
        ("universal", "revolute2"), "two revolute joints at right angles with a small link between"
    ),
    **dict.fromkeys(
        ("screw", "gearbox"), "a prismatic joint, and a revolute one that follows it with <mimic>"
    ),
}


@rule("URDF-E20", "a type of joint that does not exist", Severity.ERROR)
def unknown_type(sheet: Sheet) -> Iterator[Find]:
    """A joint of a type that URDF does not know.

    ROS says `Joint [hip] has no known type [revolut]` and refuses the robot. There are six types, in small letters: `fixed`,
    `revolute` (turns between limits), `continuous` (turns without end), `prismatic` (slides between limits), and, hardly ever
    used, `floating` and `planar`.

    Wrong:

        <joint name="hip" type="revolut">

    Right:

        <joint name="hip" type="revolute">
    """
    for joint in sheet.joints:
        if joint.type is None or joint.type in JOINT_TYPES:
            continue
        yield Find(
            joint.element.attribute("type") or joint.element,
            element=joint.element,
            what=f"{called(joint.element)} has the type {shown(joint.type)!r}, which does not exist",
            remedy=_remedy(joint.type),
            loss=REFUSED,
        )


def _remedy(written: str) -> str:
    folded = written.strip().lower()
    if folded in _NOT_THERE:
        return f"URDF has no such joint; take {_NOT_THERE[folded]}."
    near = _OTHER_NAMES.get(folded) or nearest(folded, JOINT_TYPES)
    types = f"The types are {', '.join(JOINT_TYPES)}."
    return f'Write type="{near}". {types}' if near else types
