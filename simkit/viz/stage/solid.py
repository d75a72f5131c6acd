"""What a view draws of robots and worlds: shapes with a colour, each fixed to a link."""

from __future__ import annotations

import enum
from dataclasses import dataclass
from typing import TypeAlias

from simkit.geometry import IDENTITY, ORIGIN, Quaternion, Vector
from simkit.urdf import Box, Cylinder, Sphere

Color: TypeAlias = tuple[float, float, float]
"""Red, green, blue, each from 0 to 1."""


class Role(enum.Enum):
    """What a shape is to its link."""

    VISUAL = "visual"
    """What is seen of it."""
    COLLISION = "collision"
    """What others touch of it."""
    CENTRE = "centre"
    """A ball in its centre of mass."""
    INERTIA = "inertia"
    """A box that would be as hard to turn."""
    JOINT = "joint"
    """The axis of a joint, in the frame of its child."""
    GROUND = "ground"
    """The ground that everything stands on."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TriangleMesh:
    """A surface of triangles, as bytes: the same in a page and in a picture."""

    vertices: bytes
    """x, y, z [m] of each corner, as little-endian floats of 4 bytes."""
    triangles: bytes
    """Three numbers of corners for each triangle, counter-clockwise from outside; little-endian, 4 bytes each."""
    low: Vector
    """Least x, y and z [m]."""
    high: Vector
    """Greatest x, y and z [m]."""


SolidShape: TypeAlias = Box | Cylinder | Sphere | TriangleMesh


@dataclass(frozen=True, slots=True, kw_only=True)
class Solid:
    """One shape."""

    link: str
    """The link that it is fixed to, also the name of its frame."""
    role: Role
    """What it is to the link."""
    shape: SolidShape
    """Box, cylinder along z, sphere, each around its origin, or a mesh."""
    translation: Vector = ORIGIN
    """Its origin in the frame of the link [m]."""
    rotation: Quaternion = IDENTITY
    """How it is turned in the frame of the link, xyzw."""
    color: Color
    """Its colour."""
    alpha: float = 1.0
    """Its opacity, from 0 to 1."""


def half_extents(shape: SolidShape) -> tuple[Vector, Vector]:
    """Middle, and half the lengths along x, y and z, of the box around a shape [m]."""
    match shape:
        case Box(size=(x, y, z)):
            half = (x / 2, y / 2, z / 2)
        case Cylinder(radius=radius, length=length):
            half = (radius, radius, length / 2)
        case Sphere(radius=radius):
            half = (radius, radius, radius)
        case TriangleMesh(low=low, high=high):
            middle = tuple((a + b) / 2 for a, b in zip(low, high, strict=True))
            spread = tuple((b - a) / 2 for a, b in zip(low, high, strict=True))
            return (middle[0], middle[1], middle[2]), (spread[0], spread[1], spread[2])
    return ORIGIN, half
