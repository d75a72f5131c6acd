"""The solid that the engine gets for a shape of a file."""

from __future__ import annotations

import math
from dataclasses import replace

from simkit.geometry import Vector
from simkit.physics.bodies import check_lengths
from simkit.physics.errors import ModelError
from simkit.physics.mesh import MAX_TRIANGLES, read_mesh, stand_in
from simkit.physics.plan import Plane, ShapePlan
from simkit.urdf.mesh_file import MeshError
from simkit.urdf.model import Box, Cylinder, Mesh, Sphere

SMALLEST = 1e-6
"""A shape with a smaller size [m] is none."""
PLACEHOLDER = Box((0.1, 0.1, 0.1))
"""What stands for a mesh that cannot be read."""


def with_solid(
    shape: ShapePlan, geometry: Box | Cylinder | Sphere | Plane | Mesh, notes: list[str]
) -> ShapePlan | None:
    """A shape with the solid for its geometry; None, with a note, if it has no inside.

    Args:
        shape: All of it but the solid, in the frame of the geometry.
        geometry: What the file says.
        notes: Where what is changed is noted.

    Raises:
        ModelError: A size is no number, or a plane faces nowhere.
    """
    if isinstance(geometry, Mesh):
        return _of_mesh(shape, geometry, notes)
    if isinstance(geometry, Plane):
        normal = unit(geometry.normal, f"the normal of the plane of {shape.link}")
        return replace(shape, solid=Plane(normal))
    sizes = sizes_of(geometry)
    check_lengths(sizes, f"a collision of link {shape.link}")
    if min(sizes) < SMALLEST:
        notes.append(f"a collision of {shape.link} is left out: {geometry} has no inside")
        return None
    return replace(shape, solid=geometry)


def unit(direction: Vector, what: str) -> Vector:
    """A direction at unit length.

    Raises:
        ModelError: It has no direction; `what` says of what.
    """
    length = math.hypot(*direction)
    if not math.isfinite(length) or length < 1e-12:
        x, y, z = direction
        raise ModelError(f"{what} is {x:g} {y:g} {z:g}: it points nowhere")
    return (direction[0] / length, direction[1] / length, direction[2] / length)


def _of_mesh(shape: ShapePlan, geometry: Mesh, notes: list[str]) -> ShapePlan:
    check_lengths(geometry.scale, f"the mesh of link {shape.link}")
    name = f"the mesh {geometry.filename} of {shape.link}"
    try:
        if geometry.path is None:
            raise MeshError(geometry.problem or "there is no such file")
        mesh = read_mesh(geometry.path, geometry.scale)
    except MeshError as error:
        notes.append(f"{name} is stood in for by a box of 0.1 m: {error}")
        return replace(shape, solid=PLACEHOLDER)
    solid, inner = stand_in(mesh)
    notes.append(f"others touch {name} as {_words(solid)} around it")
    return replace(
        shape,
        solid=solid,
        frame=shape.frame @ inner,
        mesh=mesh if len(mesh.corners) <= MAX_TRIANGLES else None,
        mesh_frame=shape.frame,
    )


def sizes_of(solid: Box | Cylinder | Sphere) -> tuple[float, ...]:
    """The sizes of a solid [m]."""
    match solid:
        case Box():
            return solid.size
        case Cylinder():
            return (solid.radius, solid.length)
        case Sphere():
            return (solid.radius,)


def _words(solid: Box | Cylinder | Sphere) -> str:
    match solid:
        case Box():
            return "a box of {:.3g} x {:.3g} x {:.3g} m".format(*solid.size)
        case Cylinder():
            return f"a cylinder of radius {solid.radius:.3g} m and length {solid.length:.3g} m"
        case Sphere():
            return f"a ball of radius {solid.radius:.3g} m"
