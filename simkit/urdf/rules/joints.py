"""Rules about the axis of a joint, and about joints that follow another one."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.geometry import Vector
from simkit.urdf.rules.entries import JointEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import meant_attribute
from simkit.urdf.rules.wording import called, listed, meant, numbers_text, quoted, six_digits

_ROUNDING = 0.01
"An axis may be longer or shorter than 1 by so much."
_DOES = {
    "revolute": "turns about",
    "continuous": "turns about",
    "prismatic": "slides along",
    "planar": "slides across",
}


@rule("URDF-W09", "an axis that is missing (and so x), zero, or not of length 1", Severity.ERROR)
def axis(sheet: Sheet) -> Iterator[Find]:
    """A joint without an axis, with a zero one, or one that is not of length 1.

    The joint turns about the wrong axis. A joint without `<axis>` does not turn about z, as many expect, but about the x axis
    of its own frame. An axis of zeros has no direction: ROS accepts it, Gazebo refuses the robot. Only the direction of the
    axis counts, not its length: an angle in it is without effect.

    Wrong, for a torso that is to turn about the vertical:

        <joint name="hip" type="continuous">
          <parent link="base_link"/>
          <child link="torso"/>
        </joint>

    Right:

        <joint name="hip" type="continuous">
          <axis xyz="0 0 1"/>
          <parent link="base_link"/>
          <child link="torso"/>
        </joint>
    """
    for joint in sheet.joints:
        if joint.type not in _DOES or joint.axis is None:
            continue
        length = math.hypot(*joint.axis)
        if joint.axis_element is None:
            yield _missing(joint)
        elif length == 0.0:
            yield _zero(joint)
        elif abs(length - 1.0) > _ROUNDING:
            yield _not_unit(joint, joint.axis, length)


def _missing(joint: JointEntry) -> Find:
    does = _DOES[str(joint.type)]
    return Find(
        joint.element,
        severity=Severity.WARNING,
        what=f"{called(joint.element)} has no <axis>, so it {does} x, the default",
        remedy='Say which axis is meant: <axis xyz="0 0 1"/> for z, xyz="0 1 0" for y, xyz="1 0 0" if x is right.',
        both=f"It {does} the x axis of its own frame.",
    )


def _zero(joint: JointEntry) -> Find:
    element = joint.axis_element or joint.element
    has_xyz = element.attribute("xyz") is not None
    return Find(
        Part(element, "xyz"),
        what=f"the axis of {called(joint.element)} "
        + ("is zero: it has no direction" if has_xyz else "has no xyz, and so is zero"),
        remedy='Say which axis is meant, e.g. <axis xyz="0 0 1"/>.',
        here="The joint does not move anything.",
        gazebo="ROS accepts it, and TF gets NaN; Gazebo refuses the robot: an axis has a length.",
    )


def _not_unit(joint: JointEntry, axis: Vector, length: float) -> Find:
    element = joint.axis_element or joint.element
    x, y, z = axis
    unit = numbers_text(round(value / length, 6) for value in (x, y, z))
    return Find(
        Part(element, "xyz"),
        severity=Severity.NOTE,
        what=f"the axis of {called(joint.element)} has length {six_digits(length)}, not 1",
        remedy=f'Only its direction counts: write xyz="{unit}". To turn the axis, turn the joint: <origin rpy="..."/>.',
        both="It is normalised to length 1.",
    )


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
        Part(element, "joint"),
        severity=severity,
        what=f"{called(joint.element)} {what}",
        remedy=remedy,
    )
