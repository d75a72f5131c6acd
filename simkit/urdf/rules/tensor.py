"""Rules on inertia tensors by themselves: what no body in the world can have."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.inertia import ROUNDED, gyration_radius, is_positive_definite, triangle_ratio
from simkit.urdf.matrix import IDENTITY, Matrix, eigenvalues
from simkit.urdf.rules.bodies import fitting_tensor, mass_of, reach, tensor_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.lumps import Lump, counts, lumps
from simkit.urdf.rules.paste import short, tensor_text
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called
from simkit.xml import Element

_SHAKES = (
    "The engine may jitter, spin the link up by itself, or fail; simkit says so before it starts."
)


@rule(
    "URDF-W11",
    "an inertia that no body can have",
    Severity.WARNING,
    gazebo="Newer Gazebo refuses the link (error 18, invalid inertia); in older ones it jitters or explodes.",
)
def impossible_inertia(sheet: Sheet) -> Iterator[Find]:
    """An inertia that no body can have.

    Symptom: The robot jitters, creeps, or explodes when it touches something. Newer Gazebo refuses the link.

    Cause: Numbers that were copied, rounded or mistyped. A tensor must be positive definite: turning the body about any
    axis takes effort. And no principal moment may be larger than the other two together: each mass that makes it hard to
    turn about z, far out in x or y, makes it hard to turn about y or x as well.

    Remedy: Take the formula of the shape. For a mass m, a box with sides x, y, z has ixx = m (y² + z²) / 12 and so on; a
    cylinder along z has ixx = iyy = m (3 r² + h²) / 12 and izz = m r² / 2; a ball has 2/5 m r² three times.

    Right:

        <!-- wrong: 0.01 > 0.002 + 0.002 -->
        <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.01"/>
        <!-- a disc of 1 kg, radius 0.09 m -->
        <inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.004"/>
    """
    lump_of = lumps(sheet)
    for link in sheet.links:
        tensor = _written(link)
        if tensor is None or is_zero(tensor) or is_possible(tensor):
            continue
        low, middle, high = eigenvalues(tensor)
        if not is_positive_definite(tensor):
            why = f"a principal moment is {short(low)}, and must be more than 0"
        else:
            why = f"a principal moment of {short(high)} is more than the other two together, "
            why += f"{short(low)} + {short(middle)}"
        if is_possible(_without_products(tensor)):
            why += "; without ixy, ixz and iyz it would be possible"
        yield Find(
            _tensor_element(link),
            severity=Severity.WARNING
            if counts(lump_of.get(link.name or ""), link)
            else Severity.NOTE,
            what=f"no body can have the inertia of {called(link.element)}: {why}",
            here=_SHAKES,
            remedy=tensor_remedy(link),
        )


@rule("URDF-W41", "a mass, but an inertia of zero", Severity.WARNING)
def zero_inertia(sheet: Sheet) -> Iterator[Find]:
    """A link has a mass, but an inertia of zero.

    Symptom: The link spins up at the slightest touch, or all its positions become "nan".

    Cause: Zeros as a place holder. Angular acceleration is torque divided by inertia, and that is a division by zero.

    Remedy: The values of the link's shape. A link on a fixed joint is different: it becomes one body with its parent, and
    that has the inertia.

    Right:

        <inertia ixx="0.0001" ixy="0" ixz="0" iyy="0.0001" iyz="0" izz="0.0001"/>
    """
    lump_of = lumps(sheet)
    for link in sheet.links:
        tensor = _written(link)
        if tensor is None or not is_zero(tensor):
            continue
        lump = lump_of.get(link.name or "")
        is_carried = lump is not None and _others_have_inertia(lump, link)
        yield Find(
            _tensor_element(link),
            severity=Severity.NOTE if is_carried else Severity.WARNING,
            what=f"{called(link.element)} has a mass of {short(mass_of(link))} kg and an inertia of zero",
            here="It is one body with its parent, which has an inertia." if is_carried else _SHAKES,
            gazebo="Gazebo makes one body of it and its parent: only its own share is missing."
            if is_carried
            else "Gazebo takes it, and divides by it: the link spins up, or positions become nan.",
            remedy=tensor_remedy(link),
        )


@rule(
    "URDF-W42",
    "an inertia of 1, 1, 1",
    Severity.WARNING,
    here="simkit computes with it: the link turns very sluggishly.",
    gazebo="Gazebo computes with it: the link turns very sluggishly.",
)
def identity_inertia(sheet: Sheet) -> Iterator[Find]:
    """An inertia of 1, 1, 1: copied, not computed.

    Symptom: The link turns like a flywheel of a ship. Wheels hardly start and hardly stop, an arm needs enormous torques.

    Cause: The numbers of a template. 1 kg m² is a body of 10 kg, spread over half a metre all around.

    Remedy: The values of the link's own shape and mass.

    Right:

        <!-- a wheel of 0.2 kg, radius 0.1 m, 4 cm wide, standing along z -->
        <inertia ixx="0.0005267" ixy="0" ixz="0" iyy="0.0005267" iyz="0" izz="0.001"/>
    """
    lump_of = lumps(sheet)
    for link in sheet.links:
        tensor = _written(link)
        if tensor != IDENTITY:
            continue
        size = reach(link)
        is_too_wide = size > 0.0 and gyration_radius(tensor, mass_of(link)) > size
        is_bad = is_too_wide and counts(lump_of.get(link.name or ""), link)
        yield Find(
            _tensor_element(link),
            severity=Severity.WARNING if is_bad else Severity.NOTE,
            what=f"{called(link.element)} has the inertia 1, 1, 1: numbers of a template, not of {short(mass_of(link))} kg"
            + (f" that reaches {short(size)} m" if is_too_wide else ""),
            remedy=tensor_remedy(link),
        )


def is_zero(tensor: Matrix) -> bool:
    """Whether all its entries are 0."""
    return not any(entry for row in tensor for entry in row)


def is_possible(tensor: Matrix) -> bool:
    """Whether a body can have this inertia, but for digits that were rounded away."""
    return is_positive_definite(tensor) and triangle_ratio(tensor) <= 1.0 + ROUNDED


def is_plausible(tensor: Matrix) -> bool:
    """Whether no rule of this module speaks of it."""
    return is_possible(tensor) and tensor != IDENTITY


def tensor_remedy(link: LinkEntry) -> str:
    """The tensor that fits the shape and mass of a link, in a sentence; else what to do."""
    fitting = fitting_tensor(link)
    if fitting is None:
        return "Take that of the shape: box m (y² + z²) / 12 and so on, cylinder m (3 r² + h²) / 12 and m r² / 2, ball 2/5 m r²."
    return (
        f"Its shape, filled evenly with its {short(mass_of(link))} kg, has {tensor_text(fitting)}."
    )


def _written(link: LinkEntry) -> Matrix | None:
    """The tensor of a link that has a mass."""
    return tensor_of(link.inertial) if link.inertial is not None and mass_of(link) else None


def _tensor_element(link: LinkEntry) -> Element:
    return link.element if link.inertial is None else link.inertial.inertia_element or link.element


def _without_products(tensor: Matrix) -> Matrix:
    return ((tensor[0][0], 0.0, 0.0), (0.0, tensor[1][1], 0.0), (0.0, 0.0, tensor[2][2]))


def _others_have_inertia(lump: Lump, link: LinkEntry) -> bool:
    written = (_written(one) for one in lump.members if one is not link)
    return any(tensor is not None and not is_zero(tensor) for tensor in written)
