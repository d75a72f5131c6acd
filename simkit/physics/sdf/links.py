"""Links of an SDF model: mass, shapes, and what is seen of them."""

from __future__ import annotations

from simkit.physics.plan import Plane
from simkit.physics.sdf.description import SdfCollision, SdfGeometry, SdfLink, SdfVisual
from simkit.physics.sdf.page import Page
from simkit.urdf.model import Box, Cylinder, Inertial, Mesh, Sphere
from simkit.xml import Element

_LINK = [
    "pose",
    "inertial",
    "collision",
    "visual",
    "sensor",
    "gravity",
    "self_collide",
    "velocity_decay",
]
_LINK_SILENT = ["enable_wind", "must_be_base_link", "light", "projector"]
_COLLISION = ["pose", "geometry", "surface", "laser_retro"]
_VISUAL = ["pose", "geometry", "material"]
_VISUAL_SILENT = ["cast_shadows", "transparency", "laser_retro", "meta", "plugin"]


def read_link_element(page: Page, element: Element) -> SdfLink:
    """A `<link>`."""
    page.leave_out(element, _LINK, silent=_LINK_SILENT)
    decay = element.child("velocity_decay")
    own = element.child("self_collide")
    return SdfLink(
        name=element.get("name") or "",
        pose=page.pose(element),
        inertial=_inertial(page, element),
        collisions=tuple(filter(None, (_collision(page, one) for one in element.all("collision")))),
        visuals=tuple(filter(None, (_visual(page, one) for one in element.all("visual")))),
        gravity=page.flag(element, "gravity", default=True),
        self_collide=None if own is None else page.flag(element, "self_collide"),
        decay=0.0 if decay is None else _share(page.number(decay, "linear", 0.0)),
        sensors=tuple(element.all("sensor")),
        element=element,
    )


def _inertial(page: Page, link: Element) -> Inertial | None:
    element = link.child("inertial")
    if element is None:
        return None
    page.leave_out(element, ["pose", "mass", "inertia"], silent=["frame"])
    inertia = element.child("inertia")
    moments = {name: 1.0 if name[1] == name[2] else 0.0 for name in _MOMENTS}
    if inertia is not None:
        moments = {name: page.number(inertia, name, moments[name]) for name in _MOMENTS}
    return Inertial(mass=page.number(element, "mass", 1.0), origin=page.pose(element), **moments)


_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")


def _collision(page: Page, element: Element) -> SdfCollision | None:
    page.leave_out(element, _COLLISION, silent=["max_contacts"])
    geometry = _geometry(page, element)
    if geometry is None:
        return None
    friction = across = 1.0
    surface = element.child("surface")
    if surface is not None:
        friction, across = _friction(page, surface)
    return SdfCollision(
        name=element.get("name") or "",
        geometry=geometry,
        pose=page.pose(element),
        friction=friction,
        across=across,
        retro=page.number(element, "laser_retro", 0.0),
    )


def _friction(page: Page, surface: Element) -> tuple[float, float]:
    """Friction in both directions; everything else of a surface is rigid here, and named."""
    page.leave_out(surface, ["friction"])
    friction = surface.child("friction")
    if friction is None:
        return (1.0, 1.0)
    page.leave_out(friction, ["ode"], silent=["bullet", "torsional"])
    ode = friction.child("ode")
    if ode is None:
        return (1.0, 1.0)
    page.leave_out(ode, ["mu", "mu2"])
    return (max(page.number(ode, "mu", 1.0), 0.0), max(page.number(ode, "mu2", 1.0), 0.0))


def _visual(page: Page, element: Element) -> SdfVisual | None:
    page.leave_out(element, _VISUAL, silent=_VISUAL_SILENT)
    geometry = _geometry(page, element)
    if geometry is None:
        return None
    material = element.child("material")
    script = None if material is None else material.child("script")
    rgba = None
    if material is not None:
        rgba = page.colour(material, "diffuse") or page.colour(material, "ambient")
    return SdfVisual(
        name=element.get("name") or "",
        geometry=geometry,
        pose=page.pose(element),
        rgba=rgba,
        material="" if script is None else page.text(script, "name"),
    )


def _geometry(page: Page, parent: Element) -> SdfGeometry | None:
    """The shape in a `<geometry>`; None, with a warning, if none is known."""
    element = parent.child("geometry")
    if element is None or not element.children:
        page.say(element or parent, f"the {parent.name} {parent.get('name')} has no shape", _SHAPES)
        return None
    shape = element.children[0]
    match shape.name:
        case "empty":
            return None
        case "box":
            return Box(page.vector(shape, "size", (1.0, 1.0, 1.0)))
        case "cylinder":
            return Cylinder(page.number(shape, "radius", 1.0), page.number(shape, "length", 1.0))
        case "sphere":
            return Sphere(page.number(shape, "radius", 1.0))
        case "plane":
            return Plane(page.vector(shape, "normal", (0.0, 0.0, 1.0)))
        case "mesh":
            uri = page.text(shape, "uri")
            path, problem = page.library.mesh(uri)
            scale = page.vector(shape, "scale", (1.0, 1.0, 1.0))
            return Mesh(uri, scale, path, problem)
    page.say(
        shape,
        f"the shape <{shape.name}> is not supported, so {parent.get('name')} is left out",
        _SHAPES,
    )
    return None


_SHAPES = "Use <box>, <cylinder>, <sphere>, <plane> or <mesh>."


def _share(decay: float) -> float:
    return min(max(decay, 0.0), 1.0)
