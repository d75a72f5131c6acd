"""A rule on inertias of which two numbers follow a formula, and the third one does not."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.inertia import shape_tensor, turned
from simkit.urdf.matrix import Matrix
from simkit.urdf.model import Box, Cylinder
from simkit.urdf.placed_shape import PlacedShape, Primitive
from simkit.urdf.rules.bodies import frame_of, mass_of, shapes_of, tensor_of
from simkit.urdf.rules.entries import LinkEntry
from simkit.urdf.rules.paste import short, tensor_text
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.tensor import is_possible
from simkit.urdf.rules.wording import called

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
                element.attribute(name) or element,
                element=element,
                what=f"the inertia of {called(link.element)} is that of its {_words(shape.shape)}, but for {name}: "
                f"{short(written[odd][odd])} instead of {short(formula[odd][odd])}",
                remedy=f"Write {tensor_text(formula)}.",
            )
            break


def has_odd_moment(link: LinkEntry, written: Matrix) -> bool:
    """Whether a tensor has that fault."""
    return any(True for _ in _odd(link, written))


def _odd(link: LinkEntry, written: Matrix) -> Iterator[tuple[PlacedShape, Matrix, int]]:
    """The shapes of a link that two of its three moments belong to, their tensors, and which moment is off."""
    for shape in shapes_of((*link.collisions, *link.visuals)[:_MOST_SHAPES]):
        formula = _formula(link, shape)
        odd = None if formula is None else _odd_axis(written, formula)
        if formula is not None and odd is not None:
            yield shape, formula, odd


def _formula(link: LinkEntry, shape: PlacedShape) -> Matrix | None:
    """The tensor of one shape with all the mass of a link, in the axes of its `<inertial>`."""
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if frame is None:
        return None
    rotation = frame.from_here(shape.frame).rotation
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
            return f"box of {' x '.join(short(side) for side in shape.size)} m"
        case Cylinder():
            return f"cylinder of radius {short(shape.radius)} and length {short(shape.length)} m"
        case _:
            return f"ball of radius {short(shape.radius)} m"
