"""Between the engine's matrices and our poses: translation and quaternion (x, y, z, w)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from simkit.geometry import Transform, Vector
from simkit.physics.engine import dart
from simkit.physics.errors import PhysicsError

FARTHEST = 1e6
"""Nothing is put farther from the origin of the world [m]."""


def isometry(transform: Transform) -> Any:
    """T_ab as the engine takes it."""
    return dart().math.Isometry3(np.array(transform.matrix), np.array(transform.translation))


def transform_of(isometry: Any) -> Transform:
    """T_ab of an `Isometry3` of the engine."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = isometry.matrix().tolist()
    return Transform.from_matrix((x, y, z), ((a, b, c), (d, e, f), (g, h, i)))


def checked_pose(pose: Transform) -> Transform:
    """A pose with its quaternion at unit length.

    Raises:
        PhysicsError: A number is NaN, the quaternion is zero, or it is farther than `FARTHEST`.
    """
    length = math.hypot(*pose.rotation)
    if not 1e-9 < length < math.inf or not all(abs(x) <= FARTHEST for x in pose.translation):
        raise PhysicsError(f"this is no pose: {pose.translation} with quaternion {pose.rotation}")
    return pose.normalised()


def vector(array: Any) -> Vector:
    """Three numbers of the engine as a tuple."""
    x, y, z = array.tolist()
    return (x, y, z)
