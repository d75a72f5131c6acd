"""The rule about sizes of shapes, and other numbers that must not be negative."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.model import Box, Cylinder, Geometry, Mesh, Sphere
from simkit.urdf.rules.entries import BodyEntry, JointEntry
from simkit.urdf.rules.meaning import meant_attribute
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import number_text, numbers_text, read_number
from simkit.urdf.rules.wording import called, part_of
from simkit.xml import Attribute, Element

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
        attribute,
        element=element,
        what=f"{attribute.name} {numbers_text(numbers)} in {part_of(element)} is negative",
        remedy=f'Write {attribute.name}="{right}". To move the shape, use <origin xyz="..."/>.',
        here="simkit refuses to simulate the robot.",
        gazebo="ROS accepts it; RViz draws the shape inside out, Gazebo has no such shape.",
    )


def _zero(element: Element, attribute: Attribute) -> Find:
    right = "0.1 0.1 0.1" if attribute.name == "size" else "0.1"
    right = "1 1 1" if attribute.name == "scale" else right
    return Find(
        attribute,
        severity=Severity.WARNING,
        element=element,
        what=f"{attribute.name}={attribute.value!r} in {part_of(element)} is zero: the shape has no volume",
        remedy=f'Give it a size, e.g. {attribute.name}="{right}" [m].',
        here="The shape is not seen, and nothing touches it.",
        gazebo="The shape is not seen; as a collision Gazebo refuses it, or everything falls through.",
    )


def _large(element: Element, attribute: Attribute, size: float) -> Find:
    return Find(
        attribute,
        severity=Severity.NOTE,
        element=element,
        what=f"{attribute.name} {number_text(size)} in {part_of(element)} is in metres: that is large for a robot",
        remedy=f"If millimetres are meant, write {number_text(size / 1000)}; if centimetres, {number_text(size / 100)}.",
        both="It is taken for metres.",
    )


def _of_dynamics(joint: JointEntry) -> Iterator[Find]:
    element = joint.dynamics_element
    for name in ("damping", "friction") if element is not None else ():
        attribute = None if element is None else meant_attribute(element, name, "dynamics")
        value = None if attribute is None else read_number(attribute.value)
        if attribute is not None and value is not None and value < 0.0:
            yield Find(
                attribute,
                element=element,
                what=f"{called(joint.element)} has {name} {number_text(value)}: below zero it drives the joint",
                remedy=f'Write {name}="{number_text(-value)}".',
                here="With physics the joint gains speed by itself.",
                gazebo="ROS accepts it; in Gazebo the joint gains speed by itself, and the robot explodes.",
            )
