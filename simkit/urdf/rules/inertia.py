"""Rules about the inertia of a link by itself."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.geometry import IDENTITY_MATRIX, Matrix
from simkit.urdf.inertia import (
    ROUNDED,
    eigenvalues,
    gyration_radius,
    is_positive_definite,
    shape_tensor,
    triangle_ratio,
    turned,
)
from simkit.urdf.model import Box, Cylinder
from simkit.urdf.placed_shape import PlacedShape, Primitive
from simkit.urdf.rules.bodies import (
    Lump,
    counts,
    fitting_tensor,
    frame_of,
    lumps,
    mass_of,
    reach,
    simple_parts,
    tensor_of,
)
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import called, four_digits, tensor_text
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
            why = f"a principal moment is {four_digits(low)}, and must be more than 0"
        else:
            why = f"a principal moment of {four_digits(high)} is more than the other two together, "
            why += f"{four_digits(low)} + {four_digits(middle)}"
        if is_possible(_without_products(tensor)):
            why += "; without ixy, ixz and iyz it would be possible"
        yield Find(
            tensor_element(link),
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
            tensor_element(link),
            severity=Severity.NOTE if is_carried else Severity.WARNING,
            what=f"{called(link.element)} has a mass of {four_digits(mass_of(link))} kg and an inertia of zero",
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
        if tensor != IDENTITY_MATRIX:
            continue
        size = reach(link)
        is_too_wide = size > 0.0 and gyration_radius(tensor, mass_of(link)) > size
        is_bad = is_too_wide and counts(lump_of.get(link.name or ""), link)
        yield Find(
            tensor_element(link),
            severity=Severity.WARNING if is_bad else Severity.NOTE,
            what=f"{called(link.element)} has the inertia 1, 1, 1: numbers of a template, not of {four_digits(mass_of(link))} kg"
            + (f" that reaches {four_digits(size)} m" if is_too_wide else ""),
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
    return is_possible(tensor) and tensor != IDENTITY_MATRIX


def tensor_remedy(link: LinkEntry) -> str:
    """The tensor that fits the shape and mass of a link, in a sentence; else what to do."""
    fitting = fitting_tensor(link)
    if fitting is None:
        return "Take that of the shape: box m (y² + z²) / 12 and so on, cylinder m (3 r² + h²) / 12 and m r² / 2, ball 2/5 m r²."
    return f"Its shape, filled evenly with its {four_digits(mass_of(link))} kg, has {tensor_text(fitting)}."


def _written(link: LinkEntry) -> Matrix | None:
    """The tensor of a link that has a mass."""
    return tensor_of(link.inertial) if link.inertial is not None and mass_of(link) else None


def tensor_element(link: LinkEntry) -> Element:
    """Where the tensor of a link stands."""
    return link.element if link.inertial is None else link.inertial.inertia_element or link.element


def _without_products(tensor: Matrix) -> Matrix:
    return ((tensor[0][0], 0.0, 0.0), (0.0, tensor[1][1], 0.0), (0.0, 0.0, tensor[2][2]))


def _others_have_inertia(lump: Lump, link: LinkEntry) -> bool:
    written = (_written(one) for one in lump.members if one is not link)
    return any(tensor is not None and not is_zero(tensor) for tensor in written)


_SAME, _OTHER = 0.01, 0.05
"Numbers that differ by these shares are the same, or are not."
_NAMES = ("ixx", "iyy", "izz")
_MOST_SHAPES = 20


@rule(
    "URDF-W47",
    "an inertia of which one moment is not that of the shape",
    Severity.WARNING,
    here="simkit computes with what is written.",
    gazebo="Gazebo computes with what is written.",
)
def odd_moment(sheet: Sheet) -> Iterator[Find]:
    """One of three moments of inertia is not that of the shape, and the other two are.

    Symptom: The link turns a little too easily, or too hard, about that one axis; nobody sees it.

    Cause: A slip in the formula. Of a box with the sides x, y, z, for ixx the squares of y and z are added, for iyy those of x
    and z, for izz those of x and y. Or a number was copied to the next attribute.

    Remedy: The number that the formula gives.

    Wrong, for a box of 5 kg, 0.5 x 0.3 x 0.07 m:

        <inertia ixx="0.03954" ixy="0" ixz="0" iyy="0.1062" iyz="0" izz="0.1062"/>

    Right:

        <inertia ixx="0.03954" ixy="0" ixz="0" iyy="0.1062" iyz="0" izz="0.1417"/>
    """
    for link in sheet.links:
        written = None if link.inertial is None or not mass_of(link) else tensor_of(link.inertial)
        if link.inertial is None or written is None or not is_possible(written):
            continue
        for shape, formula, odd in _odd(link, written):
            name, element = _NAMES[odd], link.inertial.inertia_element or link.element
            yield Find(
                Part(element, name),
                what=f"the inertia of {called(link.element)} is that of its {_words(shape.shape)}, but for {name}: "
                f"{four_digits(written[odd][odd])} instead of {four_digits(formula[odd][odd])}",
                remedy=f"Write {tensor_text(formula)}.",
            )
            break


def has_odd_moment(link: LinkEntry, written: Matrix) -> bool:
    """Whether a tensor has that fault."""
    return any(True for _ in _odd(link, written))


def _odd(link: LinkEntry, written: Matrix) -> Iterator[tuple[PlacedShape, Matrix, int]]:
    """The shapes of a link that two of its three moments belong to, their tensors, and which moment is off."""
    for shape in simple_parts((*link.collisions, *link.visuals)[:_MOST_SHAPES]):
        formula = _formula(link, shape)
        odd = None if formula is None else _odd_axis(written, formula)
        if formula is not None and odd is not None:
            yield shape, formula, odd


def _formula(link: LinkEntry, shape: PlacedShape) -> Matrix | None:
    """The tensor of one shape with all the mass of a link, in the axes of its `<inertial>`."""
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if frame is None:
        return None
    rotation = (frame.inverse() @ shape.frame).matrix
    return turned(shape_tensor(shape.shape, mass_of(link)), rotation)


def _odd_axis(written: Matrix, formula: Matrix) -> int | None:
    """The axis whose moment is off while the two others are right; None if there is none such."""
    off = [abs(written[axis][axis] / formula[axis][axis] - 1.0) for axis in range(3)]
    right = [axis for axis in range(3) if off[axis] < _SAME]
    wrong = [axis for axis in range(3) if off[axis] > _OTHER]
    return wrong[0] if len(right) == 2 and len(wrong) == 1 else None


def _words(shape: Primitive) -> str:
    match shape:
        case Box():
            return f"box of {' x '.join(four_digits(side) for side in shape.size)} m"
        case Cylinder():
            return f"cylinder of radius {four_digits(shape.radius)} and length {four_digits(shape.length)} m"
        case _:
            return f"ball of radius {four_digits(shape.radius)} m"
