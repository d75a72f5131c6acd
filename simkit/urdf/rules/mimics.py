"""The rule about joints that follow other joints."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.entries import JointEntry
from simkit.urdf.rules.meaning import meant_attribute
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called, listed, meant, quoted


@rule(
    "URDF-E30",
    "<mimic> of a joint that is not there, is fixed, or follows in turn",
    Severity.ERROR,
    here="simkit does as ROS does.",
    gazebo="ROS accepts the file; joint_state_publisher ends with an error, or the joint does not move.",
)
def mimic(sheet: Sheet) -> Iterator[Find]:
    """A joint that follows one that is not there, that does not move, or that follows it in turn.

    ROS accepts the file. joint_state_publisher then ends with an error, or the joint stays where it is. `<mimic>` names the
    joint to follow: position = multiplier * its position + offset. In the end there must be a joint that follows none.

    Wrong, if the joint is called `left_finger`:

        <mimic joint="left_finegr" multiplier="-1"/>

    Right:

        <mimic joint="left_finger" multiplier="-1"/>
    """
    follows = {str(joint.name): name for joint in sheet.joints if (name := _followed(joint))}
    rings = _rings(follows)
    for joint in sheet.joints:
        name = _followed(joint)
        if name is None or joint.mimic_element is None:
            continue
        other = sheet.joint_by_name.get(name)
        if other is None:
            yield _unknown(sheet, joint, name)
        elif joint.name == name:
            yield _find(joint, "follows itself", "Name the joint that it is to follow.")
        elif joint.name in rings:
            ring = " -> ".join(quoted(one) for one in rings[joint.name][:8])
            remedy = "One of them must follow none: take its <mimic> out."
            yield _find(joint, f"follows itself in the end: {ring}", remedy)
        elif other.type == "fixed":
            what = f"follows {called(other.element)}, which is fixed and never moves"
            yield _find(joint, what, "Name a joint that moves.", Severity.WARNING)


def _followed(joint: JointEntry) -> str | None:
    if joint.mimic_element is None:
        return None
    attribute = meant_attribute(joint.mimic_element, "joint", "mimic")
    return None if attribute is None else attribute.value


def _rings(follows: dict[str, str]) -> dict[str, list[str]]:
    """Each ring of joints that follow each other, by its first joint in the order of the file."""
    seen: dict[str, str] = {}
    rings: dict[str, list[str]] = {}
    for start in follows:
        name = start
        while name in follows and name not in seen:
            seen[name] = start
            name = follows[name]
        if seen.get(name) == start:
            ring = [name]
            while follows[ring[-1]] != name:
                ring.append(follows[ring[-1]])
            rings[name] = [*ring, name]
    return rings


def _unknown(sheet: Sheet, joint: JointEntry, name: str) -> Find:
    others = [one for one in sheet.joint_by_name if one != joint.name]
    near = sheet.near(name, others)
    remedy = f"{meant(near)}The other joints are {listed(others)}."
    if not others:
        remedy = "Take it out: there is no other joint that it could follow."
    if name in sheet.link_by_name:
        above = sheet.joints_above.get(name, ())
        if above and above[0].name:
            remedy = f"{quoted(name)} is a link; the joint above it is {quoted(above[0].name)}."
    what = f"follows the joint {quoted(name)}, which does not exist"
    return _find(joint, what, remedy)


def _find(joint: JointEntry, what: str, remedy: str, severity: Severity = Severity.ERROR) -> Find:
    element = joint.mimic_element or joint.element
    return Find(
        element.attribute("joint") or element,
        severity=severity,
        element=element,
        what=f"{called(joint.element)} {what}",
        remedy=remedy,
    )
