"""Projection onto a plane, and the view volume of a camera."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.vectors import Array, homogeneous

_TINY = 1e-8


def projection_matrix(
    point: ArrayLike,
    normal: ArrayLike,
    direction: ArrayLike | None = None,
    perspective: ArrayLike | None = None,
    pseudo: bool = False,
) -> Array:
    """Matrix (4, 4) that projects onto a plane.

    Args:
        point: Point (3,) of the plane [m].
        normal: Normal (3,) of the plane.
        direction: Direction (3,) of a parallel projection; the normal if None.
        perspective: Centre (3,) of a perspective projection [m]; excludes `direction`.
        pseudo: Keep relative depth, so that the matrix can be inverted; perspective only.
    """
    p = np.asarray(point, dtype=np.float64)[:3]
    n = np.asarray(normal, dtype=np.float64)[:3]
    n = n / np.linalg.norm(n)
    if perspective is not None:
        return _perspective(p, n, np.asarray(perspective, dtype=np.float64)[:3], pseudo=pseudo)
    d = n if direction is None else np.asarray(direction, dtype=np.float64)[:3]
    matrix = np.identity(4)
    matrix[:3, :3] -= np.outer(d, n) / (d @ n)
    matrix[:3, 3] = d * (p @ n) / (d @ n)
    return matrix


def _perspective(point: Array, normal: Array, centre: Array, *, pseudo: bool) -> Array:
    matrix = np.identity(4)
    height = float((centre - point) @ normal)
    matrix[:3, :3] = height * np.identity(3) - np.outer(centre, normal)
    matrix[:3, 3] = (point @ normal) * centre
    if pseudo:
        matrix[:3, :3] -= np.outer(normal, normal)
        matrix[:3, 3] += (point @ normal) * normal
    matrix[3, :3] = -normal
    matrix[3, 3] = centre @ normal
    return matrix


def projection_from_matrix(
    matrix: ArrayLike, pseudo: bool = False
) -> tuple[Array, Array, Array | None, Array | None, bool]:
    """What `projection_matrix` made a matrix (4, 4) from.

    Args:
        matrix: A projection.
        pseudo: Whether it keeps relative depth.

    Returns:
        Point (4,) of the plane; unit normal (3,), or the direction if both are the same;
        direction (3,) or None; centre (3,) of perspective or None; `pseudo`.

    Raises:
        ValueError: The matrix is no projection.
    """
    m = np.asarray(matrix, dtype=np.float64)
    if np.linalg.norm(m[3, :3]) > _TINY:
        return _perspective_parts(m, pseudo=pseudo)
    # I - M is d nᵀ / (d n), so its one singular pair is the direction and the normal.
    u, sizes, vh = np.linalg.svd(np.identity(3) - m[:3, :3] / m[3, 3])
    direction, normal = u[:, 0], vh[0]
    if abs(sizes[0] * (direction @ normal) - 1.0) > _TINY or sizes[1] > _TINY:
        raise ValueError("the matrix does not project: it flattens no direction, or several")
    point = normal * (m[:3, 3] / m[3, 3] @ direction) * (direction @ normal)
    if abs(abs(direction @ normal) - 1.0) < _TINY:
        return homogeneous(point), direction, None, None, False
    return homogeneous(point), normal, direction, None, False


def _perspective_parts(
    m: Array, *, pseudo: bool
) -> tuple[Array, Array, Array | None, Array | None, bool]:
    scale = float(np.linalg.norm(m[3, :3]))
    normal = -m[3, :3] / scale
    # M33 is height I - c nᵀ (- n nᵀ): what is orthogonal to n is only stretched by the height.
    aside = np.linalg.svd(normal[None, :])[2][1]
    height = float(aside @ m[:3, :3] @ aside) / scale
    centre = (height * np.identity(3) - m[:3, :3] / scale) @ normal
    if pseudo:
        centre = centre - normal
    point = normal * (centre @ normal - height)
    return homogeneous(point), normal, None, centre, pseudo


def clip_matrix(
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float,
    perspective: bool = False,
) -> Array:
    """Matrix (4, 4) from a view volume to the cube from -1 to 1.

    Args:
        left: Border of the volume, at the near plane if in perspective.
        right: Border, greater than `left`.
        bottom: Border.
        top: Border, greater than `bottom`.
        near: Distance of the near plane along the viewing direction.
        far: Distance of the far plane, greater than `near`.
        perspective: The volume is a frustum with its tip at the origin, else a box.

    Raises:
        ValueError: A border is not less than the opposite one, or the tip is not before `near`.
    """
    if left >= right or bottom >= top or near >= far:
        raise ValueError("an empty view volume: left < right, bottom < top and near < far are due")
    if perspective and near <= math.ulp(1.0):
        raise ValueError("a frustum needs near > 0: its tip is at distance 0")
    low, high = np.array([left, bottom, near]), np.array([right, top, far])
    size, middle = high - low, (high + low) / (high - low)
    matrix = np.zeros((4, 4))
    if perspective:
        matrix[0, 0], matrix[1, 1] = -2.0 * near / size[0], -2.0 * near / size[1]
        matrix[:3, 2] = middle * (1.0, 1.0, -1.0)
        matrix[2, 3] = 2.0 * far * near / size[2]
        matrix[3, 2] = -1.0
    else:
        matrix[:3, :3] = np.diag(2.0 / size)
        matrix[:3, 3] = -middle
        matrix[3, 3] = 1.0
    return matrix
