"""A matrix as the product of perspective, translation, rotation, shear and scale."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.euler import euler_from_matrix, euler_matrix
from simkit.tf.transformations.matrices import translation_matrix
from simkit.tf.transformations.vectors import EPS, Array

Parts = tuple[Array, list[float], list[float], Array, Array]


def compose_matrix(
    scale: ArrayLike | None = None,
    shear: ArrayLike | None = None,
    angles: ArrayLike | None = None,
    translate: ArrayLike | None = None,
    perspective: ArrayLike | None = None,
) -> Array:
    """Matrix (4, 4) that scales, shears, turns, moves and at last projects.

    Args:
        scale: Factors (3,) along x, y, z.
        shear: Slopes (3,) of x with y, x with z, y with z.
        angles: Roll, pitch, yaw (3,) [rad].
        translate: Vector (3,) [m].
        perspective: Last row (4,) of the projecting matrix.
    """
    matrix = np.identity(4)
    if perspective is not None:
        matrix[3] = np.asarray(perspective, dtype=np.float64)[:4]
    if translate is not None:
        matrix = matrix @ translation_matrix(translate)
    if angles is not None:
        roll, pitch, yaw = (float(angle) for angle in np.asarray(angles, dtype=np.float64)[:3])
        matrix = matrix @ euler_matrix(roll, pitch, yaw)
    if shear is not None:
        slopes = np.identity(4)
        slopes[0, 1], slopes[0, 2], slopes[1, 2] = np.asarray(shear, dtype=np.float64)[:3]
        matrix = matrix @ slopes
    if scale is not None:
        matrix = matrix @ np.diag([*np.asarray(scale, dtype=np.float64)[:3], 1.0])
    product: Array = matrix / matrix[3, 3]
    return product


def decompose_matrix(matrix: ArrayLike) -> Parts:
    """The arguments that `compose_matrix` makes the matrix (4, 4) from.

    Returns:
        Scale (3,), all negative if the matrix mirrors; shear, 3 slopes; roll, pitch, yaw [rad];
        translation (3,) [m]; perspective (4,).

    Raises:
        ValueError: The matrix is singular, or its last element is zero.
    """
    m = np.array(matrix, dtype=np.float64)
    if abs(m[3, 3]) < EPS:
        raise ValueError("the last element of the matrix is zero, so it cannot be normalised")
    m /= m[3, 3]
    affine = m.copy()
    affine[3] = 0.0, 0.0, 0.0, 1.0
    if not np.linalg.det(affine):
        raise ValueError("the matrix is singular: it flattens space")
    perspective = affine[3].copy()
    if np.any(np.abs(m[3, :3]) > EPS):
        perspective = m[3] @ np.linalg.inv(affine)
    rotation, triangle = _rotation_and_triangle(affine[:3, :3])
    scale = np.diagonal(triangle).copy()
    shear = [float(triangle[i, j] / scale[j]) for i, j in ((0, 1), (0, 2), (1, 2))]
    return scale, shear, list(euler_from_matrix(rotation)), affine[:3, 3].copy(), perspective


def _rotation_and_triangle(linear: Array) -> tuple[Array, Array]:
    """The proper rotation and the upper triangle, of one sign on its diagonal, of a product."""
    orthogonal, triangle = np.linalg.qr(linear)
    signs = np.sign(np.diagonal(triangle))
    orthogonal, triangle = orthogonal * signs, triangle * signs[:, None]
    if np.linalg.det(orthogonal) < 0.0:
        return -orthogonal, -triangle
    return orthogonal, triangle


def orthogonalization_matrix(lengths: ArrayLike, angles: ArrayLike) -> Array:
    """Matrix (4, 4) from coordinates along the edges of a crystal's cell to Cartesian ones.

    The third edge lies on z, the second in the plane of y and z.

    Args:
        lengths: Lengths (3,) of the edges a, b, c.
        angles: Angles (3,) between b and c, c and a, a and b [degrees].
    """
    a, b, c = (float(v) for v in np.asarray(lengths, dtype=np.float64)[:3])
    alpha, beta, gamma = (math.radians(v) for v in np.asarray(angles, dtype=np.float64)[:3])
    # Of the unit edge a, the part along y follows from its product with the edge b.
    y = (math.cos(gamma) - math.cos(alpha) * math.cos(beta)) / math.sin(alpha)
    x = math.sqrt(math.sin(beta) ** 2 - y * y)
    return np.array(
        [
            [a * x, 0.0, 0.0, 0.0],
            [a * y, b * math.sin(alpha), 0.0, 0.0],
            [a * math.cos(beta), b * math.cos(alpha), c, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
