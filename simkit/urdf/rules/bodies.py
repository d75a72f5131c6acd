"""What the rules know of a link as a body: its shapes, its mass and inertia as written, and those that fit its shapes."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.geometry import Vector
from simkit.urdf.frame import Frame
from simkit.urdf.inertia import body_of_shapes, turned
from simkit.urdf.matrix import Matrix, transpose
from simkit.urdf.model import Mesh, Pose
from simkit.urdf.placed_shape import PlacedShape, is_sound
from simkit.urdf.rules.entries import BodyEntry, InertialEntry, LinkEntry, OriginEntry

LIGHTEST = 1e-5
"""Gazebo takes a smaller mass [kg] for none."""

_FAR = 1e6
"Distances, masses and moments beyond this are slips of the pen, which other rules tell of."


def frame_of(origin: OriginEntry) -> Frame | None:
    """Where an `<origin>` puts something; None if that cannot be read."""
    if origin.xyz is None or origin.rpy is None:
        return None
    is_near = all(abs(value) < _FAR for value in (*origin.xyz, *origin.rpy))
    return Frame.of(Pose(origin.xyz, origin.rpy)) if is_near else None


def placed_shape(body: BodyEntry) -> PlacedShape | None:
    """A visual or collision in the frame of its link; None if it is a mesh or cannot be read."""
    frame = frame_of(body.origin)
    if frame is None or body.shape is None or isinstance(body.shape, Mesh):
        return None
    return PlacedShape(body.shape, frame) if is_sound(body.shape) else None


def shapes_of(bodies: Iterable[BodyEntry]) -> tuple[PlacedShape, ...]:
    """The simple shapes among some visuals or collisions of a link, in its frame."""
    return tuple(shape for one in bodies if (shape := placed_shape(one)) is not None)


def simple_shapes(bodies: tuple[BodyEntry, ...]) -> tuple[PlacedShape, ...]:
    """The shapes of some visuals or collisions if every one is simple; else none."""
    shapes = shapes_of(bodies)
    return shapes if len(shapes) == len(bodies) else ()


def solid(link: LinkEntry) -> tuple[PlacedShape, ...]:
    """What the mass of a link most likely fills: its collisions, or its visuals if it has none.

    Returns:
        The shapes in the frame of the link; none if one of them is a mesh.
    """
    return simple_shapes(link.collisions or link.visuals)


def outline(link: LinkEntry) -> tuple[PlacedShape, ...]:
    """All that is seen and touched of a link, in its frame; nothing if any of it is a mesh."""
    return simple_shapes((*link.visuals, *link.collisions))


def mass_of(link: LinkEntry) -> float:
    """The mass of a link [kg] as Gazebo sees it: 0 if it has none, or one that counts as none."""
    mass = None if link.inertial is None else link.inertial.mass
    return mass if mass is not None and LIGHTEST < mass < _FAR else 0.0


def tensor_of(inertial: InertialEntry) -> Matrix | None:
    """The tensor as written, in the axes of the `<inertial>`; None if it cannot be read."""
    if inertial.tensor is None or any(abs(entry) > _FAR for entry in inertial.tensor):
        return None
    ixx, ixy, ixz, iyy, iyz, izz = inertial.tensor
    return ((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))


def fitting_tensor(link: LinkEntry) -> Matrix | None:
    """The tensor that the mass of a link has if it fills its shapes evenly, in the axes of its `<inertial>`.

    Returns:
        About the middle of the shapes; None if link has no mass or no simple shapes.
    """
    shapes, mass = solid(link), mass_of(link)
    frame = None if link.inertial is None else frame_of(link.inertial.origin)
    if not shapes or not mass or frame is None:
        return None
    return turned(body_of_shapes(shapes, mass).tensor, transpose(frame.rotation))


def centre_of_mass(link: LinkEntry) -> Vector | None:
    """Where the mass of a link is, in its frame [m]; None if it has none or it cannot be read."""
    if link.inertial is None or not mass_of(link):
        return None
    frame = frame_of(link.inertial.origin)
    return None if frame is None else frame.origin


def reach(link: LinkEntry) -> float:
    """Distance from the centre of mass of a link to the farthest point of it [m]; 0 if that is not known."""
    centre = centre_of_mass(link)
    if centre is None:
        return 0.0
    return max((shape.farthest(centre) for shape in outline(link)), default=0.0)
