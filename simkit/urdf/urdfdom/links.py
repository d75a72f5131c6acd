"""Links as urdfdom reads them, with geometry and materials: at the first fault in a link the rest of it is lost, silently."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeAlias

from simkit.urdf.model import (
    Box,
    Collision,
    Cylinder,
    Geometry,
    Inertial,
    Material,
    Mesh,
    Pose,
    Sphere,
    Visual,
)
from simkit.urdf.urdfdom.numbers import (
    Log,
    MalformedError,
    number_of,
    origin_of,
    to_colour,
    to_vector,
)
from simkit.xml import Element

FindMesh: TypeAlias = Callable[[str], tuple[Path | None, str]]
"""Finds the file of a mesh by its name in the URDF: the file, or None and the reason."""

BLACK = (0.0, 0.0, 0.0, 1.0)
"""The colour of a material of the robot whose own could not be read."""
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


@dataclass(frozen=True, kw_only=True)
class RawVisual:
    """A visual whose material has not been looked up yet."""

    geometry: Geometry
    """Its shape."""
    origin: Pose
    """Where the shape is in the frame of the link."""
    name: str
    """Its name; mostly empty."""
    material_name: str = ""
    """The name in its `<material>`; empty if there is none."""
    material: Material | None = None
    """What its `<material>` defines; None if that is only a name."""

    def with_material(self, material: Material | None) -> Visual:
        """The visual of the model."""
        return Visual(geometry=self.geometry, origin=self.origin, name=self.name, material=material)


class RawLink:
    """A link as far as it could be read.

    Args:
        name: Its name; empty if it has none.
    """

    def __init__(self, name: str = "") -> None:
        self.name = name
        self.inertial: Inertial | None = None
        """Its inertial; of one with a fault what came before the fault."""
        self.visuals: list[RawVisual] = []
        """Its visuals up to the first fault."""
        self.has_all_visuals = False
        """Whether it got beyond its visuals."""
        self.collisions: list[Collision] = []
        """Its collisions up to the first fault."""


def read_link(element: Element, log: Log, find_mesh: FindMesh) -> RawLink:
    """A link, as far as it can be read."""
    name = element.written("name")
    if name is None:
        log.error("No name given for the link.")
        return RawLink()
    link = RawLink(name)
    part = "inertial"
    try:
        inertial = element.child("inertial")
        if inertial is not None:
            _read_inertial(inertial, link)
        part = "visual"
        for visual in element.all("visual"):
            link.visuals.append(_read_visual(visual, log, find_mesh))
        link.has_all_visuals = True
        part = "collision"
        for collision in element.all("collision"):
            link.collisions.append(_read_collision(collision, find_mesh))
    except MalformedError as fault:
        log.error(str(fault))
        log.error(f"Could not parse {part} element for Link [{name}]")
    return link


def _read_inertial(element: Element, link: RawLink) -> None:
    """Give the link its inertial, bit by bit: what comes before a fault stays."""
    link.inertial = Inertial(mass=0.0)
    origin = origin_of(element)
    link.inertial = Inertial(mass=0.0, origin=origin)
    mass = element.child("mass")
    if mass is None:
        raise MalformedError("Inertial element must have a mass element")
    if mass.written("value") is None:
        raise MalformedError("Inertial: mass element must have value attribute")
    value = number_of(mass, "value", "Inertial: mass [{}] is not a float")
    link.inertial = Inertial(mass=value, origin=origin)
    tensor = element.child("inertia")
    if tensor is None:
        raise MalformedError("Inertial element must have inertia element")
    link.inertial = Inertial(mass=value, origin=origin, **_read_tensor(tensor))


def _read_tensor(element: Element) -> dict[str, float]:
    found = {}
    for name in _TENSOR:
        if element.written(name) is None:
            raise MalformedError(f"Inertial: inertia element missing {name} attribute")
        complaint = f"Inertial: inertia element {name} is not a valid double"
        found[name] = number_of(element, name, complaint)
    return found


def _read_visual(element: Element, log: Log, find_mesh: FindMesh) -> RawVisual:
    origin = origin_of(element)
    geometry = read_geometry(element, find_mesh)
    name = element.written("name") or ""
    inner = element.child("material")
    if inner is None:
        return RawVisual(geometry=geometry, origin=origin, name=name)
    if inner.written("name") is None:
        raise MalformedError("Visual material must contain a name attribute")
    material = read_material(inner, log)
    return RawVisual(
        geometry=geometry,
        origin=origin,
        name=name,
        material_name=material.name,
        material=material if is_defined(material) else None,
    )


def _read_collision(element: Element, find_mesh: FindMesh) -> Collision:
    origin = origin_of(element)
    geometry = read_geometry(element, find_mesh)
    return Collision(geometry=geometry, origin=origin, name=element.written("name") or "")


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
