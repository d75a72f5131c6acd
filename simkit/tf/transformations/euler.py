"""Euler angles: to and from matrices and quaternions, for any of the 24 axis sequences."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.axes import Axes, AxisSequence, axis_sequence
from simkit.tf.transformations.quaternions import (
    quaternion_about_axis,
    quaternion_matrix,
    quaternion_multiply,
)
from simkit.tf.transformations.vectors import EPS, Array

_UNIT_AXES = np.identity(3)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Array:
    """Unit quaternion (4,) of three turns.

    Args:
        ai: First angle [rad]; roll for the default axes.
        aj: Second angle [rad]; pitch.
        ak: Third angle [rad]; yaw.
        axes: Sequence of axes.

    Raises:
        UnknownNameError: There is no such sequence of axes.
    """
    sequence = axis_sequence(axes)
    first, third = (ak, ai) if sequence.rotating else (ai, ak)
    last_axis = sequence.i if sequence.repeated else sequence.k
    q0 = quaternion_about_axis(first, _UNIT_AXES[sequence.i])
    q1 = quaternion_about_axis(aj, _UNIT_AXES[sequence.j])
    q2 = quaternion_about_axis(third, _UNIT_AXES[last_axis])
    return quaternion_multiply(q2, quaternion_multiply(q1, q0))


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Array:
    """Rotation matrix (4, 4) of three turns; arguments as `quaternion_from_euler`."""
    return quaternion_matrix(quaternion_from_euler(ai, aj, ak, axes))


def euler_from_matrix(matrix: ArrayLike, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Angles [rad] of a rotation matrix (3, 3) or (4, 4).

    Where the first and the third axis fall together only their sum is defined: then the third
    turn (of the fixed-axes order) is zero.

    Raises:
        UnknownNameError: There is no such sequence of axes.
    """
    sequence = axis_sequence(axes)
    rotation = np.asarray(matrix, dtype=np.float64)[:3, :3]
    angles = _repeated(rotation, sequence) if sequence.repeated else _distinct(rotation, sequence)
    if sequence.odd:
        angles = (-angles[0], -angles[1], -angles[2])
    return (angles[2], angles[1], angles[0]) if sequence.rotating else angles


def euler_from_quaternion(quaternion: ArrayLike, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Angles [rad] of a quaternion (4,); (roll, pitch, yaw) for the default axes.

    Raises:
        UnknownNameError: There is no such sequence of axes.
    """
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def _distinct(r: Array, sequence: AxisSequence) -> tuple[float, float, float]:
    """Angles about three different axes in cyclic order.

    The image of axis i is (cos a_j cos a_k, cos a_j sin a_k, -sin a_j) on the axes i, j, k.
    """
    i, j, k = sequence[:3]
    cosine = math.hypot(r[i, i], r[j, i])
    middle = math.atan2(-r[k, i], cosine)
    if cosine <= EPS:
        return math.atan2(-r[j, k], r[j, j]), middle, 0.0
    return math.atan2(r[k, j], r[k, k]), middle, math.atan2(r[j, i], r[i, i])


def _repeated(r: Array, sequence: AxisSequence) -> tuple[float, float, float]:
    """Angles about i, j and i again, in cyclic order.

    The angle between axis i and its image is a_j; the other two say where the image lies.
    """
    i, j, k = sequence[:3]
    sine = math.hypot(r[i, j], r[i, k])
    middle = math.atan2(sine, r[i, i])
    if sine <= EPS:
        return math.atan2(-r[j, k], r[j, j]), middle, 0.0
    return math.atan2(r[i, j], r[i, k]), middle, math.atan2(r[j, i], -r[k, i])
