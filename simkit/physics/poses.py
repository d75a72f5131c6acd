"""Between the engine's matrices and our poses: translation and quaternion (x, y, z, w)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from simkit.geometry import Quaternion, Vector, multiply, rotate
from simkit.physics.engine import dart
from simkit.physics.errors import PhysicsError
from simkit.urdf.frame import Frame
from simkit.urdf.kinematics import Placement
from simkit.urdf.matrix import Matrix

FARTHEST = 1e6
"""Nothing is put farther from the origin of the world [m]."""


def isometry(frame: Frame) -> Any:
    """T_ab as the engine takes it."""
    return dart().math.Isometry3(np.array(frame.rotation), np.array(frame.origin))


def placement(transform: Any) -> Placement:
    """T_ab of an `Isometry3` of the engine."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = transform.matrix().tolist()
    return Placement((x, y, z), quaternion(((a, b, c), (d, e, f), (g, h, i))))


def frame_of(pose: Placement) -> Frame:
    """A pose with its rotation as a matrix.

    Raises:
        PhysicsError: A number is none, the quaternion is zero, or it is beyond all places.
    """
    x, y, z, w = pose.rotation
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if not 1e-9 < length < math.inf or not all(abs(x) <= FARTHEST for x in pose.translation):
        raise PhysicsError(f"this is no pose: {pose.translation} with quaternion {pose.rotation}")
    x, y, z, w = x / length, y / length, z / length, w / length
    rotation: Matrix = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return Frame(rotation, pose.translation)


def quaternion(matrix: Matrix) -> Quaternion:
    """The unit quaternion of a rotation; w is not negative unless it is small.

    Source:
        Shepperd's method: divide by the largest of the four.
    """
    (a, b, c), (d, e, f), (g, h, i) = matrix
    trace = a + e + i
    if trace > 0.0:
        s = 2.0 * math.sqrt(1.0 + trace)
        return ((h - f) / s, (c - g) / s, (d - b) / s, s / 4.0)
    if a >= e and a >= i:
        s = 2.0 * math.sqrt(1.0 + a - e - i)
        return (s / 4.0, (b + d) / s, (c + g) / s, (h - f) / s)
    if e >= i:
        s = 2.0 * math.sqrt(1.0 + e - a - i)
        return ((b + d) / s, s / 4.0, (f + h) / s, (c - g) / s)
    s = 2.0 * math.sqrt(1.0 + i - a - e)
    return ((c + g) / s, (f + h) / s, s / 4.0, (d - b) / s)


def then(outer: Placement, inner: Placement) -> Placement:
    """T_ac = T_ab T_bc, for T_ab = `outer` and T_bc = `inner`."""
    x, y, z = rotate(outer.rotation, inner.translation)
    tx, ty, tz = outer.translation
    return Placement((tx + x, ty + y, tz + z), multiply(outer.rotation, inner.rotation))


def vector(array: Any) -> Vector:
    """Three numbers of the engine as a tuple."""
    x, y, z = array.tolist()
    return (x, y, z)
