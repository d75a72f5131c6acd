"""Geometry and materials as urdfdom reads them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeAlias

from simkit.urdf.model import Box, Cylinder, Geometry, Material, Mesh, Sphere
from simkit.urdf.urdfdom.log import Log
from simkit.urdf.urdfdom.numbers import MalformedError, number_of, to_colour, to_vector
from simkit.xml import Element

FindMesh: TypeAlias = Callable[[str], tuple[Path | None, str]]
"""Finds the file of a mesh by its name in the URDF: the file, or None and the reason."""

BLACK = (0.0, 0.0, 0.0, 1.0)
"""The colour of a material of the robot whose own could not be read."""


def read_geometry(holder: Element, find_mesh: FindMesh) -> Geometry:
    """The shape in the first `<geometry>` of a visual or collision.

    Raises:
        MalformedError: There is none; without words if `<geometry>` itself is missing.
    """
    geometry = holder.child("geometry")
    if geometry is None:
        raise MalformedError
    if not geometry.children:
        raise MalformedError("Geometry tag contains no child element.")
    shape = geometry.children[0]
    match shape.name:
        case "box":
            return _box(shape)
        case "cylinder":
            return _cylinder(shape)
        case "sphere":
            return _sphere(shape)
        case "mesh":
            return _mesh(shape, find_mesh)
    raise MalformedError(f"Unknown geometry type '{shape.name}'")


def _box(shape: Element) -> Box:
    size = shape.written("size")
    if size is None:
        raise MalformedError("Box shape has no size attribute")
    return Box(to_vector(size))


def _cylinder(shape: Element) -> Cylinder:
    if shape.written("length") is None or shape.written("radius") is None:
        raise MalformedError("Cylinder shape must have both length and radius attributes")
    length = number_of(shape, "length", "length [{}] is not a valid float")
    return Cylinder(number_of(shape, "radius", "radius [{}] is not a valid float"), length)


def _sphere(shape: Element) -> Sphere:
    if shape.written("radius") is None:
        raise MalformedError("Sphere shape must have a radius attribute")
    return Sphere(number_of(shape, "radius", "radius [{}] is not a valid float"))


def _mesh(shape: Element, find_mesh: FindMesh) -> Mesh:
    filename, scale = shape.written("filename"), shape.written("scale")
    if filename is None:
        raise MalformedError("Mesh must contain a filename attribute")
    try:
        factors = (1.0, 1.0, 1.0) if scale is None else to_vector(scale)
    except MalformedError as fault:
        raise MalformedError(
            f"Mesh scale was specified, but could not be parsed: {fault}"
        ) from None
    path, problem = find_mesh(filename)
    return Mesh(filename, factors, path, problem)


def read_material(element: Element, log: Log) -> Material:
    """A material; without colour and picture if it has none that can be read."""
    name = element.written("name")
    if name is None:
        log.error("Material must contain a name attribute")
        return Material("")
    texture, colour = element.child("texture"), element.child("color")
    filename = None if texture is None else texture.written("filename")
    rgba = None if colour is None else colour.written("rgba")
    if rgba is None:
        return Material(name, None, filename)
    try:
        return Material(name, to_colour(rgba), filename)
    except MalformedError as fault:
        log.error(f"Material [{name}] has malformed color rgba values: {fault}")
        return Material(name, None, filename)


def is_defined(material: Material) -> bool:
    """Whether a material is more than a name."""
    return material.rgba is not None or material.texture is not None


def read_global_material(element: Element, log: Log) -> Material:
    """A material of the robot; urdfdom keeps it as black, with a complaint, if it says nothing."""
    material = read_material(element, log)
    if is_defined(material) or element.written("name") is None:
        return material
    log.error(f"Material [{material.name}] color has no rgba")
    log.error(f"Material [{material.name}] not defined in file")
    return Material(material.name, BLACK)
