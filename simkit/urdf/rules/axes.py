"""The rule about the axis of a joint."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.geometry import Vector
from simkit.urdf.rules.entries import JointEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import number_text, numbers_text
from simkit.urdf.rules.wording import called

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
        element.attribute("xyz") or element,
        element=element,
        what=f"the axis of {called(joint.element)} "
        + ("is zero: it has no direction" if has_xyz else "has no xyz, and so is zero"),
        remedy='Say which axis is meant, e.g. <axis xyz="0 0 1"/>.',
        here="The joint does not move anything.",
        gazebo="ROS accepts it, and TF gets numbers that are none; Gazebo refuses the robot: an axis has a length.",
    )


def _not_unit(joint: JointEntry, axis: Vector, length: float) -> Find:
    element = joint.axis_element or joint.element
    x, y, z = axis
    unit = numbers_text(round(value / length, 6) for value in (x, y, z))
    return Find(
        element.attribute("xyz") or element,
        severity=Severity.NOTE,
        element=element,
        what=f"the axis of {called(joint.element)} has length {number_text(length)}, not 1",
        remedy=f'Only its direction counts: write xyz="{unit}". To turn the axis, turn the joint: <origin rpy="..."/>.',
        both="It is made one long.",
    )
