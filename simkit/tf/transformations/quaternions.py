"""Quaternions (x, y, z, w)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.vectors import EPS, Array


def quaternion_about_axis(angle: float, axis: ArrayLike) -> Array:
    """Quaternion (4,) of a turn by `angle` [rad] about `axis` (3,), of any length."""
    direction = np.asarray(axis, dtype=np.float64)[:3]
    length = float(np.linalg.norm(direction))
    scale = math.sin(angle / 2.0) / length if length > EPS else 1.0
    return np.append(direction * scale, math.cos(angle / 2.0))


def quaternion_multiply(quaternion1: ArrayLike, quaternion0: ArrayLike) -> Array:
    """Hamilton product (4,): the rotation `quaternion0`, then `quaternion1`."""
    q1, q0 = (np.asarray(q, dtype=np.float64) for q in (quaternion1, quaternion0))
    v1, w1, v0, w0 = q1[:3], q1[3], q0[:3], q0[3]
    return np.append(w1 * v0 + w0 * v1 + np.cross(v1, v0), w1 * w0 - v1 @ v0)


def quaternion_conjugate(quaternion: ArrayLike) -> Array:
    """The quaternion (4,) with its axis reversed; the inverse of a unit quaternion."""
    return np.asarray(quaternion, dtype=np.float64) * (-1.0, -1.0, -1.0, 1.0)


def quaternion_inverse(quaternion: ArrayLike) -> Array:
    """The quaternion (4,) whose product with the given one is (0, 0, 0, 1)."""
    q = np.asarray(quaternion, dtype=np.float64)
    return quaternion_conjugate(q) / (q @ q)


def quaternion_matrix(quaternion: ArrayLike) -> Array:
    """Rotation matrix (4, 4) of a quaternion of any length; of the zero quaternion, identity."""
    q = np.array(quaternion, dtype=np.float64)[:4]
    square = float(q @ q)
    matrix = np.identity(4)
    if square < EPS:
        return matrix
    x, y, z, w = q * math.sqrt(2.0 / square)
    matrix[:3, :3] = [
        [1.0 - y * y - z * z, x * y - z * w, x * z + y * w],
        [x * y + z * w, 1.0 - x * x - z * z, y * z - x * w],
        [x * z - y * w, y * z + x * w, 1.0 - x * x - y * y],
    ]
    return matrix


def quaternion_from_matrix(matrix: ArrayLike) -> Array:
    """Unit quaternion (4,) of a rotation matrix (4, 4).

    w is positive if the trace of the rotation is, else the largest of x, y, z is.
    """
    m = np.asarray(matrix, dtype=np.float64)
    r = m[:3, :3] / m[3, 3]
    trace = r[0, 0] + r[1, 1] + r[2, 2]
    q = np.empty(4)
    if trace > 0.0:
        q[3] = 1.0 + trace
        q[:3] = r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]
        return q * (0.5 / math.sqrt(q[3]))
    # The component that is surely not small, so that nothing is divided by nearly zero.
    i = int(np.argmax(np.diagonal(r)))
    j, k = (i + 1) % 3, (i + 2) % 3
    q[i] = 1.0 + r[i, i] - r[j, j] - r[k, k]
    q[j] = r[i, j] + r[j, i]
    q[k] = r[i, k] + r[k, i]
    q[3] = r[k, j] - r[j, k]
    return q * (0.5 / math.sqrt(q[i]))


def quaternion_slerp(
    quat0: ArrayLike,
    quat1: ArrayLike,
    fraction: float,
    spin: int = 0,
    shortestpath: bool = True,
) -> Array:
    """Unit quaternion (4,) at `fraction` of the way on the great circle between two rotations.

    Args:
        quat0: Rotation at fraction 0.
        quat1: Rotation at fraction 1.
        fraction: Where on the way.
        spin: So many half turns are added on the way.
        shortestpath: Take the shorter of the two ways.
    """
    q0, q1 = (np.array(q, dtype=np.float64)[:4] for q in (quat0, quat1))
    q0, q1 = q0 / np.linalg.norm(q0), q1 / np.linalg.norm(q1)
    if fraction in (0.0, 1.0):
        return q1 if fraction else q0
    cosine = float(q0 @ q1)
    if abs(abs(cosine) - 1.0) < EPS:
        return q0
    if shortestpath and cosine < 0.0:
        cosine, q1 = -cosine, -q1
    angle = math.acos(cosine) + spin * math.pi
    if abs(angle) < EPS:
        return q0
    a, b = math.sin((1.0 - fraction) * angle), math.sin(fraction * angle)
    result: Array = (a * q0 + b * q1) / math.sin(angle)
    return result
