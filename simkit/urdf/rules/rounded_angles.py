"""A rule on right angles that were rounded."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.entries import OriginEntry
from simkit.urdf.rules.paste import short
from simkit.urdf.rules.sheet import Sheet

_FINE, _ROUGH = 5e-5, 5e-3
"Angles that miss a multiple of 90 degrees by more than the one and less than the other [rad] were rounded."
_RIGHT = math.pi / 2.0


@rule(
    "URDF-I46",
    "a right angle with too few digits",
    Severity.NOTE,
    here="simkit turns it by what is written.",
    gazebo="ROS and Gazebo turn it by what is written.",
)
def rounded_angle(sheet: Sheet) -> Iterator[Find]:
    """A right angle with too few digits.

    Symptom: A wheel wobbles by a hair, an arm that should be level is not quite: a tenth of a degree is 2 mm at the end of a
    metre.

    Cause: 90 degrees are 1.570796 rad. 1.57 is 0.05 degrees less, 3.14 is 0.09 degrees less than 180.

    Remedy: Six digits behind the point.

    Wrong:

        <origin rpy="1.57 0 0"/>

    Right:

        <origin rpy="1.570796 0 0"/>
    """
    found = [(origin, value) for origin in _origins(sheet) for value in _rounded(origin)]
    if not found:
        return
    origin, value = found[0]
    right = _RIGHT * round(value / _RIGHT)
    more = f", and {len(found) - 1} more like it" if len(found) > 1 else ""
    element = origin.element
    if element is None:
        return
    yield Find(
        element.attribute("rpy") or element,
        element=element,
        what=f"{value:g} misses {math.degrees(right):.0f}° by {short(abs(math.degrees(value - right)))}°{more}",
        remedy=f"Write {right:.6f} if a right angle is meant; mostly it does not matter.",
    )


def _origins(sheet: Sheet) -> Iterator[OriginEntry]:
    """All origins of a file, joints first."""
    for joint in sheet.joints:
        yield joint.origin
    for link in sheet.links:
        for body in (*link.visuals, *link.collisions):
            yield body.origin
        if link.inertial is not None:
            yield link.inertial.origin


def _rounded(origin: OriginEntry) -> list[float]:
    """The angles of an origin that miss a multiple of 90 degrees, not 0, by a little."""
    return [
        value
        for value in origin.rpy or ()
        if abs(value) > 1.0 and _FINE < abs(value - _RIGHT * round(value / _RIGHT)) < _ROUGH
    ]
