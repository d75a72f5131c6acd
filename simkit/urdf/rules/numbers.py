"""Rules about numbers that cannot be read, and about sizes that no shape has."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.diagnostics.table import Loss
from simkit.urdf.model import Box, Cylinder, Geometry, Mesh, Sphere
from simkit.urdf.rules.entries import BodyEntry, JointEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import in_context, meant_attribute
from simkit.urdf.rules.wording import (
    called,
    loss,
    mended,
    numbers_text,
    part_of,
    read_number,
    shown,
    six_digits,
)
from simkit.urdf.urdfdom.numbers import to_double
from simkit.xml import Attribute, Element

_VECTORS = {
    "origin": ("xyz", "rpy"),
    "axis": ("xyz",),
    "box": ("size",),
    "mesh": ("scale",),
}
_NUMBERS = {
    "cylinder": ("radius", "length"),
    "sphere": ("radius",),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "limit": ("lower", "upper", "effort", "velocity"),
    "dynamics": ("damping", "friction"),
    "mimic": ("multiplier", "offset"),
    "calibration": ("rising", "falling"),
    "safety_controller": ("soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"),
}
_COUNTS: Mapping[tuple[str, str], int] = {
    **{(word, name): 3 for word, names in _VECTORS.items() for name in names},
    **{(word, name): 1 for word, names in _NUMBERS.items() for name in names},
}
_EXAMPLES = {"rpy": "0 0 1.5708", "size": "0.1 0.1 0.2", "scale": "1 1 1"}
_WITHOUT_AXIS = ("fixed", "floating")
_MOST_LINES = 10
"A value over more lines is not looked at so closely."


@rule("URDF-E19", "no number, or not as many as needed (commas, units, formulas)", Severity.ERROR)
def bad_number(sheet: Sheet) -> Iterator[Find]:
    """Something that is not a number, or not as many numbers as there should be.

    ROS says `Unable to parse component [0,] to a double`, and names no line. Numbers stand with spaces between them, without
    commas, brackets, units or formulas; the point is a point, not a comma. In a joint ROS then refuses the robot; in a link it
    loses the rest of the link and goes on, which is worse, for the robot loads and has holes.

    Wrong:

        <origin xyz="0, 0, 0.05" rpy="0 pi/2 0"/>

    Right:

        <origin xyz="0 0 0.05" rpy="0 1.5708 0"/>
    """
    if sheet.robot is None:
        return
    for element, context in in_context(sheet.robot):
        for attribute in element.attributes:
            count = _COUNTS.get((context, attribute.name))
            if count is not None:
                trouble = _trouble(sheet, attribute, count)
                if trouble:
                    yield _bad(element, attribute, count, trouble)


def _trouble(sheet: Sheet, attribute: Attribute, count: int) -> str:
    """What is wrong with a value, for a sentence; empty if nothing is."""
    value = attribute.value
    if count == 1:
        if to_double(value) is not None:
            return ""
        return "has a space behind it" if read_number(value) is not None else "is not a number"
    words = [word for word in value.split(" ") if word]
    if any(read_number(word) is None for word in words):
        return _odd_word(words)
    if len(words) != count:
        have = f"{len(words)} number{'' if len(words) == 1 else 's'}" if words else "nothing"
        return f"holds {have} where {count} are needed"
    if any(to_double(word) is None for word in _as_written(sheet, attribute).split(" ") if word):
        return "has a tab or a new line behind a number, where ROS knows only spaces"
    return ""


def _as_written(sheet: Sheet, attribute: Attribute) -> str:
    """The value with its tabs and newlines, which XML turns into spaces and ROS does not."""
    number, start = attribute.value_span.line, attribute.value_span.column - 1
    line = sheet.document.line(number)
    quote, rest = line[start - 1 : start], line[start:]
    pieces: list[str] = []
    while quote in ("'", '"') and quote not in rest and len(pieces) < _MOST_LINES:
        pieces.append(rest)
        number += 1
        rest = sheet.document.line(number)
    written = "\n".join([*pieces, rest.partition(quote or " ")[0]])
    is_it = " ".join(written.split()) == " ".join(attribute.value.split())
    return written if is_it else attribute.value


def _odd_word(words: list[str]) -> str:
    word = next(word for word in words if read_number(word) is None)
    if word == "," or (word.endswith(",") and read_number(word[:-1]) is not None):
        return "has commas between its numbers"
    return f"holds {shown(word)!r}, which is not a number"


def _bad(element: Element, attribute: Attribute, count: int, trouble: str) -> Find:
    right = mended(attribute.value, count)
    many = "one number" if count == 1 else f"{count} numbers with spaces between them"
    example = _EXAMPLES.get(attribute.name, "0 0 0.5") if count > 1 else "0.5"
    if element.name == "axis":
        example = "0 0 1"
    follows = _follows(element)
    return Find(
        Part(element, attribute.name),
        what=f"{attribute.name}={shown(attribute.value)!r} of {part_of(element)} {trouble}",
        remedy=f'Write {attribute.name}="{right}".'
        if right is not None
        else f'Write {many}, e.g. {attribute.name}="{example}".',
        loss=follows,
    )


def _follows(element: Element) -> Loss:
    joint = element.parent
    if element.name == "axis" and joint is not None and joint.get("type") in _WITHOUT_AXIS:
        return Loss(
            severity=Severity.NOTE,
            here="It is not looked at: this joint has no axis.",
            gazebo="It is not looked at: this joint has no axis.",
        )
    return loss(element)


_HUGE = 20.0
"Robots are smaller; a ground plane may be as large [m]."


@rule(
    "URDF-E31",
    "a size that is negative, zero or far too large; negative damping or friction",
    Severity.ERROR,
)
def bad_size(sheet: Sheet) -> Iterator[Find]:
    """A size that is negative or zero, or far too large; damping or friction below zero.

    ROS accepts it. RViz draws nothing, or the inside of the shape; Gazebo refuses the shape or falls over it. Sizes are lengths
    of edges, radii and lengths in metres: who writes 50 gets a wheel of 50 m, and perhaps meant millimetres.

    Wrong:

        <cylinder radius="50" length="-0.05"/>

    Right:

        <cylinder radius="0.05" length="0.05"/>
    """
    for link in sheet.links:
        for body in (*link.visuals, *link.collisions):
            yield from _of_shape(body)
    for joint in sheet.joints:
        yield from _of_dynamics(joint)


def _of_shape(body: BodyEntry) -> Iterator[Find]:
    element, shape = body.shape_element, body.shape
    if element is None or shape is None:
        return
    for name, context, numbers in _sizes(shape):
        attribute = meant_attribute(element, name, context)
        if attribute is None:
            continue
        if min(numbers) < 0.0 and context != "mesh":
            yield _negative(element, attribute, numbers)
        elif min(map(abs, numbers)) == 0.0:
            yield _zero(element, attribute)
        elif max(numbers) > _HUGE and context != "mesh":
            yield _large(element, attribute, max(numbers))


def _sizes(shape: Geometry) -> list[tuple[str, str, tuple[float, ...]]]:
    """Each attribute with sizes, the word that it belongs to, and its numbers."""
    match shape:
        case Box():
            return [("size", "box", shape.size)]
        case Sphere():
            return [("radius", "sphere", (shape.radius,))]
        case Cylinder():
            return [
                ("radius", "cylinder", (shape.radius,)),
                ("length", "cylinder", (shape.length,)),
            ]
        case Mesh():
            return [("scale", "mesh", shape.scale)]


def _negative(element: Element, attribute: Attribute, numbers: tuple[float, ...]) -> Find:
    right = numbers_text(abs(number) for number in numbers)
    return Find(
        Part(element, attribute.name),
        what=f"{attribute.name} {numbers_text(numbers)} in {part_of(element)} is negative",
        remedy=f'Write {attribute.name}="{right}". To move the shape, use <origin xyz="..."/>.',
        here="simkit refuses to simulate the robot.",
        gazebo="ROS accepts it; RViz draws the shape inside out, Gazebo has no such shape.",
    )


def _zero(element: Element, attribute: Attribute) -> Find:
    right = "0.1 0.1 0.1" if attribute.name == "size" else "0.1"
    right = "1 1 1" if attribute.name == "scale" else right
    return Find(
        Part(element, attribute.name),
        severity=Severity.WARNING,
        what=f"{attribute.name}={attribute.value!r} in {part_of(element)} is zero: the shape has no volume",
        remedy=f'Give it a size, e.g. {attribute.name}="{right}" [m].',
        here="The shape is not seen, and nothing touches it.",
        gazebo="The shape is not seen; as a collision Gazebo refuses it, or everything falls through.",
    )


def _large(element: Element, attribute: Attribute, size: float) -> Find:
    return Find(
        Part(element, attribute.name),
        severity=Severity.NOTE,
        what=f"{attribute.name} {six_digits(size)} in {part_of(element)} is in metres: that is large for a robot",
        remedy=f"If millimetres are meant, write {six_digits(size / 1000)}; if centimetres, {six_digits(size / 100)}.",
        both="It is taken for metres.",
    )


def _of_dynamics(joint: JointEntry) -> Iterator[Find]:
    element = joint.dynamics_element
    if element is None:
        return
    for name in ("damping", "friction"):
        attribute = meant_attribute(element, name, "dynamics")
        value = None if attribute is None else read_number(attribute.value)
        if attribute is not None and value is not None and value < 0.0:
            yield Find(
                Part(element, attribute.name),
                what=f"{called(joint.element)} has {name} {six_digits(value)}: below zero it drives the joint",
                remedy=f'Write {name}="{six_digits(-value)}".',
                here="With physics the joint gains speed by itself.",
                gazebo="ROS accepts it; in Gazebo the joint gains speed by itself, and the robot explodes.",
            )
