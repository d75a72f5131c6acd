"""Rules about angles: degrees where radians are meant, and right angles that are rounded."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.entries import JointEntry, OriginEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called, four_digits, numbers_text, part_of, six_digits

_FULL_TURN = 2 * math.pi * 1.05
"A larger angle [rad] is more than a turn, rounding aside."
_FEW_TURNS = 15.0
"Some motors turn a few times; up to here [rad] only whole numbers look like degrees."
_UNLIMITED = 3600.0
_UNLIMITED_TOO = (10.0, 100.0, 1000.0)
"Who writes one of these, or more than the number above, means that there is no limit [rad]."
_ROUNDING = 0.01


@rule("URDF-W07", "degrees where radians are meant", Severity.WARNING)
def degrees(sheet: Sheet) -> Iterator[Find]:
    """Degrees where radians are meant.

    Nothing complains. A joint with `upper="90"` turns fourteen times before it stops, and `rpy="0 90 0"` turns a part by 90
    radians, which looks like any odd angle. URDF knows no degrees: 180 degrees are 3.1416, 90 are 1.5708, 45 are 0.7854.

    Wrong:

        <limit lower="-90" upper="90" effort="10" velocity="1"/>

    Right:

        <limit lower="-1.5708" upper="1.5708" effort="10" velocity="1"/>
    """
    for joint in sheet.joints:
        if joint.type == "revolute":
            yield from _in_limits(joint)
        yield from _in_origin(joint.origin)
    for link in sheet.links:
        bodies = (*link.visuals, *link.collisions)
        if link.inertial is not None:
            yield from _in_origin(link.inertial.origin)
        for body in bodies:
            yield from _in_origin(body.origin)


def look_like_degrees(angle: float) -> bool:
    """Whether an angle [rad] is most likely one in degrees: more than a turn, and no number of quarter turns."""
    size = abs(angle)
    if size <= _FULL_TURN or size >= _UNLIMITED or size in _UNLIMITED_TOO:
        return False
    quarter = math.pi / 2
    is_some_quarters = abs(math.remainder(size, quarter)) < _ROUNDING and size < 32 * quarter
    return not is_some_quarters and (size > _FEW_TURNS or size == round(size))


def _in_limits(joint: JointEntry) -> Iterator[Find]:
    limit = joint.limit
    if limit is None or limit.lower is None or limit.upper is None:
        return
    values = {"lower": limit.lower, "upper": limit.upper}
    bad = [name for name, value in values.items() if look_like_degrees(value)]
    if not bad:
        return
    largest = max(abs(values[name]) for name in bad)
    written = " ".join(f'{name}="{six_digits(values[name])}"' for name in bad)
    yield Find(
        Part(limit.element, bad[0]),
        what=f"{called(joint.element)} has {written}: {six_digits(largest)} rad is {_turns(largest)} turns, so this looks "
        "like degrees",
        remedy=f"Angles are in radians: write {_mended(values)}.",
        here=f"From stop to stop the joint turns by {_turns(limit.upper - limit.lower)} revolutions.",
        gazebo="ROS and Gazebo take the number for radians, too.",
    )


def _turns(angle: float) -> str:
    return six_digits(round(abs(angle) / (2 * math.pi), 1))


def _mended(values: Mapping[str, float]) -> str:
    return " ".join(f'{name}="{_radians(value)}"' for name, value in values.items())


def _in_origin(origin: OriginEntry) -> Iterator[Find]:
    if origin.element is None or origin.rpy is None:
        return
    bad = [angle for angle in origin.rpy if look_like_degrees(angle)]
    if bad:
        mended = " ".join(_radians(angle) for angle in origin.rpy)
        off = six_digits(round(math.degrees(math.remainder(bad[0], 2 * math.pi)), 1))
        yield Find(
            Part(origin.element, "rpy"),
            what=f"rpy {numbers_text(origin.rpy)!r} of {part_of(origin.element)} is more than a turn in radians, so this "
            "looks like degrees",
            remedy=f'Angles are in radians: write rpy="{mended}".',
            here=f"{six_digits(bad[0])} rad is the same as {off} degrees: the part stands askew.",
            gazebo="ROS and Gazebo take the number for radians, too.",
        )


def _radians(angle_in_degrees: float) -> str:
    return f"{math.radians(angle_in_degrees):.4f}".rstrip("0").rstrip(".")


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
        Part(element, "rpy"),
        what=f"{value:g} misses {math.degrees(right):.0f}° by {four_digits(abs(math.degrees(value - right)))}°{more}",
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
