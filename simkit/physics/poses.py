"""Between the engine's matrices and our poses: translation and quaternion (x, y, z, w)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from simkit.geometry import Transform, Vector
from simkit.physics.engine import dart
from simkit.physics.errors import PhysicsError
from simkit.urdf.frame import Frame
from simkit.urdf.matrix import Matrix

FARTHEST = 1e6
"""Nothing is put farther from the origin of the world [m]."""


def isometry(frame: Frame) -> Any:
    """T_ab as the engine takes it."""
    return dart().math.Isometry3(np.array(frame.rotation), np.array(frame.origin))


def placement(transform: Any) -> Transform:
    """T_ab of an `Isometry3` of the engine."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = transform.matrix().tolist()
    return Transform.from_matrix((x, y, z), ((a, b, c), (d, e, f), (g, h, i)))


def frame_of(pose: Transform) -> Frame:
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


def vector(array: Any) -> Vector:
    """Three numbers of the engine as a tuple."""
    x, y, z = array.tolist()
    return (x, y, z)
