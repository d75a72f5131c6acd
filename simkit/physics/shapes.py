"""The shapes of links: the solid that the engine gets for each, and its surface."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace

from simkit.geometry import Vector
from simkit.physics.errors import ModelError
from simkit.physics.gazebo_tags import GazeboTags, LinkTags
from simkit.physics.mesh import MAX_TRIANGLES, CollisionMesh, stand_in
from simkit.physics.plan import (
    JointKind,
    JointPlan,
    Plane,
    ShapePlan,
    Solid,
    check_lengths,
    check_pose,
)
from simkit.physics.rigid_groups import Member, RigidGroup
from simkit.urdf.mesh_file import MeshError, read_mesh
from simkit.urdf.model import Box, Collision, Cylinder, Mesh, Sphere
from simkit.urdf.wheel import is_wheel

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
        mesh = CollisionMesh.of(read_mesh(geometry.path, geometry.scale).corners)
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


FRICTION = 1.0
"""Of a link about which nothing is said."""


@dataclass(slots=True)
class _Shelf:
    """What is made of the shapes of one group."""

    leader: str
    tags: GazeboTags
    shapes: list[ShapePlan] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    names: set[str] = field(default_factory=set)


def shapes_of(group: RigidGroup, tags: GazeboTags) -> tuple[tuple[ShapePlan, ...], list[str]]:
    """The shapes of a group in its frame, and what is not as the file says.

    Raises:
        ModelError: A number of a shape is NaN.
    """
    shelf = _Shelf(group.name, tags)
    for member in group.members:
        for collision in member.link.collisions:
            _add(shelf, member, collision)
        link = tags.of_link(member.link.name)
        if member.link.collisions:
            note_friction(member.link.name, _friction(link), link.across, shelf.notes)
    return tuple(shelf.shapes), shelf.notes


def note_friction(link: str, friction: float, across: float | None, notes: list[str]) -> None:
    """Note that friction is the same in all directions here, if the file wants something else."""
    if across is not None and across != friction:
        notes.append(
            f"friction of {link} is {friction:g} all round: mu2 = {across:g} has no effect"
        )


def _add(shelf: _Shelf, member: Member, collision: Collision) -> None:
    link = member.link.name
    check_pose(collision.origin, f"a collision of link {link}")
    tags = shelf.tags.of_link(link)
    base = ShapePlan(
        name=_name(shelf, member, collision),
        link=link,
        solid=PLACEHOLDER,
        frame=member.frame @ collision.origin.transform,
        friction=_friction(tags),
        retro=tags.retro or 0.0,
    )
    shape = with_solid(base, collision.geometry, shelf.notes)
    if shape is not None:
        shelf.shapes.append(shape)


def _friction(tags: LinkTags) -> float:
    return FRICTION if tags.friction is None else tags.friction


def _name(shelf: _Shelf, member: Member, collision: Collision) -> str:
    """Name of a collision: that of its link or its own, with the name of the body that took it in.

    Source:
        sdformat's conversion: `<link>_collision`, further ones `_1`, `_2`; of a link that was merged
        `<body>_fixed_joint_lump__<link>_collision`.
    """
    own = collision.name or member.link.name
    is_guest = member.link.name != shelf.leader
    is_one_of_many = bool(collision.name) and len(member.link.collisions) > 1
    prefix = f"{shelf.leader}_fixed_joint_lump__" if is_guest or is_one_of_many else ""
    name, number = f"{prefix}{own}_collision", 1
    while name in shelf.names:
        name, number = f"{prefix}{own}_collision_{number}", number + 1
    shelf.names.add(name)
    return name


WIDTH = 0.002
"""Width of what touches of a wheel [m]: how far wheels are apart is off by less than that."""


def contact_solid(shape: ShapePlan, joint: JointPlan) -> Solid:
    """What the engine computes contacts of for a shape that hangs on a joint: of a wheel the middle of its tread.

    Two bodies that touch along a line share the load along it; an engine that knows points gives it to the
    two ends of the line, in any shares that hold the body up. For a wheel that means an edge: the robot
    turns as if its wheels were as far apart as these edges, by ten per cent off and another amount in each
    curve. A tyre is rounder. So the solid that the engine is given for a wheel is narrow, in the middle of the
    one that is seen, and that lasers see.

    Args:
        shape: The shape, in the frame of the child of the joint.
        joint: The joint.
    """
    solid = shape.solid
    if isinstance(solid, Cylinder) and _is_turning_wheel(solid, shape, joint):
        return Cylinder(radius=solid.radius, length=min(solid.length, WIDTH))
    return solid


def _is_turning_wheel(solid: Cylinder, shape: ShapePlan, joint: JointPlan) -> bool:
    """Whether a cylinder turns round and round about its own axis."""
    is_endless = not math.isfinite(joint.lower) and not math.isfinite(joint.upper)
    if joint.kind is not JointKind.REVOLUTE or not is_endless:
        return False
    axis = joint.anchor.rotate(joint.axis)
    return is_wheel(solid, shape.frame, axis=axis, origin=joint.anchor.translation)
