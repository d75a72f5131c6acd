"""Links as urdfdom reads them: at the first fault in a link the rest of it is lost, silently."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.urdf.model import Collision, Geometry, Inertial, Material, Pose, Visual
from simkit.urdf.urdfdom.log import Log
from simkit.urdf.urdfdom.numbers import MalformedError, number_of, origin_of
from simkit.urdf.urdfdom.shapes import FindMesh, is_defined, read_geometry, read_material
from simkit.xml import Element

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
