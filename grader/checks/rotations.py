"""Rotations as plain matrices: the oracle of checks, which shares no code with tf.

A rotation is three rows; its columns are the axes of the turned frame.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

Point: TypeAlias = tuple[float, float, float]
Rotation: TypeAlias = tuple[Point, Point, Point]
"Rows of a rotation matrix."


def rotation_of(roll: float, pitch: float, yaw: float) -> Rotation:
    """R = Rz(yaw) Ry(pitch) Rx(roll), as the rpy of URDF means it [rad]."""
    return times(times(about_z(yaw), about_y(pitch)), about_x(roll))


def about_x(angle: float) -> Rotation:
    """A turn about x [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return ((1.0, 0.0, 0.0), (0.0, c, -s), (0.0, s, c))


def about_y(angle: float) -> Rotation:
    """A turn about y [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return ((c, 0.0, s), (0.0, 1.0, 0.0), (-s, 0.0, c))


def about_z(angle: float) -> Rotation:
    """A turn about z [rad]."""
    c, s = math.cos(angle), math.sin(angle)
    return ((c, -s, 0.0), (s, c, 0.0), (0.0, 0.0, 1.0))


def times(a: Rotation, b: Rotation) -> Rotation:
    """The product of two rotations: first b, then a."""
    columns = tuple(zip(*b, strict=True))
    return tuple(tuple(dot(row, column) for column in columns) for row in a)  # type: ignore[return-value]


def back(rotation: Rotation) -> Rotation:
    """The turn back: the transpose."""
    return tuple(zip(*rotation, strict=True))  # type: ignore[return-value]


def apart(a: Rotation, b: Rotation) -> float:
    """The angle between two orientations [rad]."""
    trace = sum(times(back(a), b)[i][i] for i in range(3))
    return math.acos(max(-1.0, min(1.0, (trace - 1.0) / 2.0)))


def of_quaternion(turn: Any) -> Rotation:
    """The rotation of a geometry_msgs/Quaternion of unit length."""
    x, y, z, w = turn.x, turn.y, turn.z, turn.w
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )


def dot(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    """The sum of the products."""
    return sum(one * other for one, other in zip(a, b, strict=True))
