"""Worlds and robots of students in physics: started, spawned, and measured as they stand there.

All places and directions are those of the world.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from grader.checks.rotations import Point, Rotation, back, dot, of_quaternion, rotation_of, times
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.gazebo import Gazebo, Spawned
from simkit.physics import Model
from simkit.urdf import Box, Collision, Cylinder, Link, Sphere, Visual


class Place(NamedTuple):
    """Where a link is in the world."""

    origin: Point
    """[m]."""
    turn: Rotation
    """Its axes, as columns."""


class _Quaternion(NamedTuple):
    x: float
    y: float
    z: float
    w: float


def started_world(sim: Simulation, roslaunch: Callable[..., Any], file: str) -> Gazebo:
    """The world that a student's launch file starts; its time passes.

    Args:
        sim: The simulation of the check.
        roslaunch: The fixture.
        file: Name of the launch file.

    Raises:
        CheckFailed: It starts none.
    """
    roslaunch(file)
    if not sim.has_world:
        raise CheckFailed(
            f"{file} starts no world",
            hint="Include $(find gazebo_ros)/launch/empty_world.launch, which starts one. Its argument world_name is "
            "the path of a .world file, with its ending.",
        )
    sim.gazebo.unpause()
    return sim.gazebo


def spawned_robot(
    sim: Simulation,
    text: str,
    *,
    name: str,
    xyz: Point = (0.0, 0.0, 0.0),
    rpy: Point = (0.0, 0.0, 0.0),
) -> Spawned:
    """A student's robot, just spawned; an empty world with a ground is started if there is none.

    Args:
        sim: The simulation of the check.
        text: Its URDF.
        name: Its name in the world.
        xyz: Where [m].
        rpy: Turned by roll, pitch, yaw [rad].

    Raises:
        CheckFailed: There is nothing in it that can be simulated.
        SpawnError: It cannot be spawned.
    """
    spawned = sim.spawn(text, name=name, xyz=xyz, rpy=rpy)
    if not spawned.model.links:
        raise CheckFailed(
            f"{name} is empty in the world: none of its links is simulated",
            hint="Gazebo simulates a link only if it has a mass: give each link an <inertial>. A link that is left out "
            "takes everything attached to it with it.",
        )
    return spawned


def place_of(model: Model, link: str) -> Place:
    """Where a link of a model is.

    Raises:
        CheckFailed: It is not simulated.
    """
    if link not in model.links:
        raise CheckFailed(
            f"the link {link} is not in the world",
            expected=f"a link {link} with a mass",
            actual=f"links in the world: {', '.join(sorted(model.links))}",
            hint="A link needs an <inertial> with a mass to be simulated, and a joint that holds it.",
        )
    pose = model.link_pose(link)
    return Place(pose.translation, of_quaternion(_Quaternion(*pose.rotation)))


def point_of(place: Place, point: Point) -> Point:
    """Where a point of a link is in the world.

    Args:
        place: Where the link is.
        point: The point, in the frame of the link [m].
    """
    x, y, z = (p + dot(row, point) for p, row in zip(place.origin, place.turn, strict=True))
    return (x, y, z)


@dataclass(frozen=True, slots=True, kw_only=True)
class Solid:
    """A shape as it stands in the world."""

    kind: str
    """`box`, `cylinder`, `sphere` or `mesh`."""
    centre: Point
    """Its middle [m]."""
    size: Point
    """How much room it takes along x, y, z [m]; zeros for a mesh."""


def solid_of(shape: Visual | Collision, place: Place) -> Solid:
    """A shape of a link as it stands in the world.

    Args:
        shape: What is seen or touched of the link.
        place: Where the link is.
    """
    turn = times(place.turn, rotation_of(*shape.origin.rpy))
    geometry = shape.geometry
    match geometry:
        case Box():
            x, y, z = (
                sum(abs(r) * s for r, s in zip(row, geometry.size, strict=True)) for row in turn
            )
        case Cylinder():
            x, y, z = (_reach(geometry, row[2]) for row in turn)
        case Sphere():
            x = y = z = 2 * geometry.radius
        case _:
            x = y = z = 0.0
    return Solid(
        kind=type(geometry).__name__.lower(),
        centre=point_of(place, shape.origin.xyz),
        size=(x, y, z),
    )


def inertia_of(link: Link, place: Place) -> Rotation:
    """The inertia of a link about its centre of mass, in the axes of the world [kg m^2]; zeros if it has none.

    Args:
        link: The link, as its URDF says.
        place: Where it is.
    """
    one = link.inertial
    if one is None:
        return ((0.0, 0.0, 0.0),) * 3
    written = (
        (one.ixx, one.ixy, one.ixz),
        (one.ixy, one.iyy, one.iyz),
        (one.ixz, one.iyz, one.izz),
    )
    return turned_inertia(written, times(place.turn, rotation_of(*one.origin.rpy)))


def turned_inertia(tensor: Rotation, turn: Rotation) -> Rotation:
    """An inertia in other axes [kg m^2].

    Args:
        tensor: Its rows, in the axes of a body.
        turn: These axes, as columns, in the axes that it is wanted in.
    """
    return times(turn, times(tensor, back(turn)))


def loads(gazebo: Gazebo, model: str) -> dict[str, float]:
    """How hard the world holds each link of a model up, in the last step [N], by link.

    Args:
        gazebo: The world.
        model: Name of the model.
    """
    found: dict[str, float] = {}
    for contact in gazebo.world.contacts():
        for side, sign in ((contact.first, 1.0), (contact.second, -1.0)):
            if side.model == model:
                found[side.link] = found.get(side.link, 0.0) + sign * contact.force[2]
    return found


def _reach(cylinder: Cylinder, along: float) -> float:
    """Room that a cylinder takes in a direction in which its axis has the part `along`."""
    across = math.sqrt(max(0.0, 1.0 - along * along))
    return 2 * cylinder.radius * across + cylinder.length * abs(along)
