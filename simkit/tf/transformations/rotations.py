"""Rotation about an axis anywhere in space."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.quaternions import (
    quaternion_about_axis,
    quaternion_from_matrix,
    quaternion_matrix,
)
from simkit.tf.transformations.vectors import EPS, Array, homogeneous


def rotation_matrix(angle: float, direction: ArrayLike, point: ArrayLike | None = None) -> Array:
    """Matrix (4, 4) of a turn by `angle` [rad].

    Args:
        angle: Angle [rad], right-handed.
        direction: Direction (3,) of the axis, of any length.
        point: A point (3,) on the axis [m]; the origin if None.
    """
    matrix = quaternion_matrix(quaternion_about_axis(angle, direction))
    if point is not None:
        fixed = np.asarray(point, dtype=np.float64)[:3]
        matrix[:3, 3] = fixed - matrix[:3, :3] @ fixed
    return matrix


def rotation_from_matrix(matrix: ArrayLike) -> tuple[float, Array, Array]:
    """Angle and axis of a matrix (4, 4) that turns.

    Returns:
        Angle [rad] in [0, π]; unit direction (3,); the point (4,) of the axis that is nearest
        to the origin. A matrix that also moves along its axis (a screw) gives the screw's axis.
        Without a turn the direction is z.
    """
    m = np.asarray(matrix, dtype=np.float64)
    q = quaternion_from_matrix(m)
    q = -q if q[3] < 0.0 else q
    sine = float(np.linalg.norm(q[:3]))
    direction = q[:3] / sine if sine > EPS else np.array([0.0, 0.0, 1.0])
    move = m[:3, 3] / m[3, 3]
    across = move - direction * (direction @ move)
    # The smallest solution of (I - R) p = across is the foot of the perpendicular.
    point = np.linalg.lstsq(np.identity(3) - m[:3, :3] / m[3, 3], across, rcond=1e-12)[0]
    return 2.0 * math.atan2(sine, float(q[3])), direction, homogeneous(point)
