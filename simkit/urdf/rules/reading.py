"""Reads entries from elements, whatever is wrong with them."""

from __future__ import annotations

from simkit.geometry import Vector
from simkit.urdf.model import Box, Cylinder, Geometry, Mesh, Sphere
from simkit.urdf.rules.entries import (
    BodyEntry,
    GazeboEntry,
    InertialEntry,
    JointEntry,
    LimitEntry,
    LinkEntry,
    MaterialEntry,
    OriginEntry,
    PluginElement,
    TransmissionEntry,
)
from simkit.urdf.rules.vocabulary import (
    SHAPES,
    WORDS,
    first,
    meant_attribute,
    meant_children,
    meant_word,
)
from simkit.urdf.rules.wording import read_number, read_rgba, read_vector
from simkit.xml import Element

_TENSOR = WORDS["inertia"].required


def link_entry(element: Element) -> LinkEntry:
    """A `<link>`."""
    parts = meant_children(element, "link")
    inertial = first(parts["inertial"])
    return LinkEntry(
        element=element,
        name=_name(element, "link"),
        inertial=None if inertial is None else _inertial(inertial),
        visuals=tuple(_body(one, "visual") for one in parts["visual"]),
        collisions=tuple(_body(one, "collision") for one in parts["collision"]),
    )


def joint_entry(element: Element) -> JointEntry:
    """A `<joint>` of the robot."""
    parts = {name: first(found) for name, found in meant_children(element, "joint").items()}
    limit = parts["limit"]
    return JointEntry(
        element=element,
        name=_name(element, "joint"),
        type=_text(element, "type", "joint"),
        parent_element=parts["parent"],
        parent=_link_of(parts["parent"]),
        child_element=parts["child"],
        child=_link_of(parts["child"]),
        origin=_origin(parts["origin"]),
        axis_element=parts["axis"],
        axis=_axis(parts["axis"]),
        limit=None if limit is None else _limit(limit),
        dynamics_element=parts["dynamics"],
        mimic_element=parts["mimic"],
    )


def material_entry(element: Element, *, is_global: bool) -> MaterialEntry:
    """A `<material>`."""
    parts = meant_children(element, "material")
    color, texture = first(parts["color"]), first(parts["texture"])
    return MaterialEntry(
        element=element,
        name=_text(element, "name", "material"),
        is_global=is_global,
        color_element=color,
        rgba=None if color is None else read_rgba(_text(color, "rgba", "color")),
        texture=None if texture is None else _text(texture, "filename", "texture"),
    )


def gazebo_entry(element: Element) -> GazeboEntry:
    """A `<gazebo>`."""
    return GazeboEntry(element=element, reference=element.get("reference"))


def plugin_elements(gazebo: GazeboEntry) -> list[PluginElement]:
    """The plugins in a `<gazebo>`, in its sensors too."""
    return [
        PluginElement(
            element=one, gazebo=gazebo, name=one.get("name"), filename=one.get("filename")
        )
        for one in gazebo.element.walk()
        if one.name == "plugin"
    ]


def transmission_entry(element: Element) -> TransmissionEntry:
    """A `<transmission>`."""
    kind = element.child("type")
    return TransmissionEntry(
        element=element,
        name=element.get("name"),
        type=None if kind is None else kind.text.strip() or None,
        joints=tuple(element.all("joint")),
        actuators=tuple(element.all("actuator")),
    )


def _text(element: Element, name: str, context: str) -> str | None:
    found = meant_attribute(element, name, context)
    return None if found is None else found.value


def _name(element: Element, context: str) -> str | None:
    return _text(element, "name", context) or None


def _number(element: Element | None, name: str, context: str) -> float | None:
    return None if element is None else read_number(_text(element, name, context))


def _link_of(element: Element | None) -> str | None:
    """Name of the link in `<parent>` or `<child>`; also if it is written as in SDF, as text."""
    if element is None:
        return None
    return _text(element, "link", "parent") or element.text.strip() or None


def _origin(element: Element | None) -> OriginEntry:
    if element is None:
        return OriginEntry(element=None)
    return OriginEntry(element=element, xyz=_triple(element, "xyz"), rpy=_triple(element, "rpy"))


def _triple(origin: Element, name: str) -> Vector | None:
    written = _text(origin, name, "origin")
    return (0.0, 0.0, 0.0) if written is None else read_vector(written)


def _axis(element: Element | None) -> Vector | None:
    if element is None:
        return (1.0, 0.0, 0.0)
    written = _text(element, "xyz", "axis")
    return (0.0, 0.0, 0.0) if written is None else read_vector(written)


def _limit(element: Element) -> LimitEntry:
    def bound(name: str) -> float | None:
        written = _text(element, name, "limit")
        return 0.0 if written is None else read_number(written)

    return LimitEntry(
        element=element,
        lower=bound("lower"),
        upper=bound("upper"),
        effort=_number(element, "effort", "limit"),
        velocity=_number(element, "velocity", "limit"),
    )


def _inertial(element: Element) -> InertialEntry:
    parts = {name: first(found) for name, found in meant_children(element, "inertial").items()}
    tensor = [_number(parts["inertia"], name, "inertia") for name in _TENSOR]
    ixx, ixy, ixz, iyy, iyz, izz = tensor
    whole = None
    if not (ixx is None or ixy is None or ixz is None or iyy is None or iyz is None or izz is None):
        whole = (ixx, ixy, ixz, iyy, iyz, izz)
    return InertialEntry(
        element=element,
        origin=_origin(parts["origin"]),
        mass_element=parts["mass"],
        mass=_number(parts["mass"], "value", "mass"),
        inertia_element=parts["inertia"],
        tensor=whole,
    )


def _body(element: Element, context: str) -> BodyEntry:
    parts = meant_children(element, context)
    geometry = first(parts["geometry"])
    shape = first(() if geometry is None else geometry.children)
    return BodyEntry(
        element=element,
        is_visual=context == "visual",
        origin=_origin(first(parts["origin"])),
        geometry_element=geometry,
        shape_element=shape,
        shape=None if shape is None else _shape(shape),
        material_element=first(parts.get("material", ())),
    )


def _shape(element: Element) -> Geometry | None:
    kind = meant_word(element, SHAPES)
    if kind == "box":
        size = read_vector(_text(element, "size", "box"))
        return None if size is None else Box(size)
    if kind == "mesh":
        return _mesh(element)
    radius = _number(element, "radius", kind) if kind in ("cylinder", "sphere") and kind else None
    if radius is None:
        return None
    if kind == "sphere":
        return Sphere(radius)
    length = _number(element, "length", "cylinder")
    return None if length is None else Cylinder(radius, length)


def _mesh(element: Element) -> Mesh | None:
    filename = _text(element, "filename", "mesh")
    scale = _text(element, "scale", "mesh")
    factors = (1.0, 1.0, 1.0) if scale is None else read_vector(scale)
    return None if filename is None or factors is None else Mesh(filename, factors)
