"""What a scene is made of: solids, each fixed to a link, and marks, the points and lines of one moment."""

from __future__ import annotations

import enum
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

from simkit.geometry import IDENTITY, ORIGIN, Quaternion, Vector, multiply, rotate
from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.frames import FramePose

_CORNERS = tuple((x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1))

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


def along(start: Vector, direction: Vector, length: float) -> Vector:
    """The point at a length [m] from another one in a direction of unit length."""
    x, y, z = (s + length * d for s, d in zip(start, direction, strict=True))
    return (x, y, z)


def corners(solid: Solid, frame: FramePose | None) -> Iterator[Vector]:
    """The corners of the box around a shape, in the fixed frame [m].

    Args:
        solid: The shape.
        frame: The frame of its link; None for the fixed frame.
    """
    middle, half = half_extents(solid.shape)
    origin, turn = placed_in(frame, solid.translation, solid.rotation)
    for signs in _CORNERS:
        x, y, z = (m + s * h for m, s, h in zip(middle, signs, half, strict=True))
        dx, dy, dz = rotate(turn, (x, y, z))
        yield (origin[0] + dx, origin[1] + dy, origin[2] + dz)


def placed_in(
    frame: FramePose | None, translation: Vector, rotation: Quaternion
) -> tuple[Vector, Quaternion]:
    """A pose in a frame as a pose in the fixed frame; None is the fixed frame."""
    if frame is None:
        return translation, rotation
    x, y, z = rotate(frame.rotation, translation)
    a, b, c = frame.origin
    return (a + x, b + y, c + z), multiply(frame.rotation, rotation)


Polyline: TypeAlias = tuple[Vector, ...]
"""Corners of a line in the fixed frame [m]."""

POINT_SIZE: Final = 0.007
"""Side of a point, as a share of the distance of the camera at first."""
LINE_WIDTH: Final = 0.003
"""Width of a line, as a share of that distance."""
_DIGITS = 4


@dataclass(frozen=True, slots=True, kw_only=True)
class Marks:
    """One display of points and lines, with a checkbox of its own."""

    name: str
    """Its name, of letters and hyphens: no other display of the scene has it."""
    label: str
    """What stands at its checkbox."""
    color: str
    """Its colour, `#rrggbb`."""
    points: tuple[Vector, ...] = ()
    """Points in the fixed frame [m]."""
    colors: tuple[str, ...] = ()
    """A colour for each point, `#rrggbb`, if each has its own."""
    lines: tuple[Polyline, ...] = ()
    """Lines in the fixed frame [m]."""
    is_on: bool = True
    """Whether it is seen at first."""
    shines_through: bool = False
    """Whether it is seen through the shapes that are before it."""
    is_many_colored: bool = False
    """Whether each point has a colour of its own; then it has no lines."""


def marks_data(marks: Marks) -> dict[str, Any]:
    """All of it, for the script of a view."""
    return {
        "name": marks.name,
        "color": marks.color,
        "isMany": marks.is_many_colored,
        "through": marks.shines_through,
        **moment_data(marks),
    }


def moment_data(marks: Marks) -> dict[str, Any]:
    """That of it which changes: coordinates one after the other."""
    data: dict[str, Any] = {
        "points": _flat(marks.points),
        "lines": [_flat(line) for line in marks.lines],
    }
    if marks.colors:
        palette = sorted(set(marks.colors))
        data["palette"] = palette
        data["colors"] = [palette.index(color) for color in marks.colors]
    return data


def _flat(points: Iterable[Vector]) -> list[float]:
    return [round(value, _DIGITS) for point in points for value in point]
