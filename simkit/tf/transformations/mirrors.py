"""What bends or mirrors a body: reflection, scaling and shear, and what a matrix says of them."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.vectors import EPS, Array, homogeneous, normal_of_rank_one


def reflection_matrix(point: ArrayLike, normal: ArrayLike) -> Array:
    """Matrix (4, 4) that mirrors at the plane through `point` (3,) [m] with `normal` (3,)."""
    return _along(-1.0, _unit(normal), np.asarray(point, dtype=np.float64)[:3])


def reflection_from_matrix(matrix: ArrayLike) -> tuple[Array, Array]:
    """Point (4,) and unit normal (3,) of the plane at which a matrix (4, 4) mirrors.

    Raises:
        ValueError: The matrix is no reflection.
    """
    m = np.asarray(matrix, dtype=np.float64)
    normal = normal_of_rank_one(np.identity(3) - m[:3, :3])
    point = normal * (normal @ m[:3, 3]) / 2.0
    if not np.allclose(reflection_matrix(point, normal), m):
        raise ValueError("the matrix is not a reflection: no axis is turned into its opposite")
    return homogeneous(point), normal


def scale_matrix(
    factor: float, origin: ArrayLike | None = None, direction: ArrayLike | None = None
) -> Array:
    """Matrix (4, 4) that scales by `factor`; -1 mirrors.

    Args:
        factor: Ratio of lengths.
        origin: Point (3,) that stays [m]; the origin if None.
        direction: The only direction (3,) that is scaled; all if None.
    """
    fixed = np.zeros(3) if origin is None else np.asarray(origin, dtype=np.float64)[:3]
    if direction is not None:
        return _along(factor, _unit(direction), fixed)
    matrix = np.diag([factor, factor, factor, 1.0])
    matrix[:3, 3] = (1.0 - factor) * fixed
    return matrix


def scale_from_matrix(matrix: ArrayLike) -> tuple[float, Array, Array | None]:
    """Factor, fixed point (4,) and direction (3,) of a matrix (4, 4) that scales.

    Returns:
        The direction is None if all directions are scaled.
    """
    m = np.asarray(matrix, dtype=np.float64)
    stretch = np.identity(3) - m[:3, :3]
    factor = 1.0 - float(np.trace(stretch)) / 3.0
    if np.allclose(stretch, (1.0 - factor) * np.identity(3)):
        fixed = m[:3, 3] / (1.0 - factor) if abs(1.0 - factor) > EPS else np.zeros(3)
        return factor, homogeneous(fixed), None
    lost = float(np.trace(stretch))
    direction = normal_of_rank_one(stretch)
    return 1.0 - lost, homogeneous(direction * (direction @ m[:3, 3]) / lost), direction


def shear_matrix(angle: float, direction: ArrayLike, point: ArrayLike, normal: ArrayLike) -> Array:
    """Matrix (4, 4) that shears: points move along `direction`, in proportion to their height.

    Args:
        angle: A line along the normal is tilted by this [rad].
        direction: Direction (3,) of the motion, in the plane.
        point: Point (3,) of the plane that stays [m].
        normal: Normal (3,) of that plane.

    Raises:
        ValueError: The direction does not lie in the plane.
    """
    n, d = _unit(normal), _unit(direction)
    if abs(n @ d) > 1e-6:
        raise ValueError("the direction must lie in the plane: it is not orthogonal to the normal")
    matrix = np.identity(4)
    matrix[:3, :3] += math.tan(angle) * np.outer(d, n)
    matrix[:3, 3] = -math.tan(angle) * (np.asarray(point, dtype=np.float64)[:3] @ n) * d
    return matrix


def shear_from_matrix(matrix: ArrayLike) -> tuple[float, Array, Array, Array]:
    """Angle [rad], direction (3,), point (4,) and normal (3,) of a matrix (4, 4) that shears.

    Raises:
        ValueError: The matrix is no shear.
    """
    m = np.asarray(matrix, dtype=np.float64)
    u, slopes, vh = np.linalg.svd(m[:3, :3] - np.identity(3))
    direction, normal = u[:, 0], vh[0]
    if slopes[0] < EPS or slopes[1] > 1e-8 * slopes[0] or abs(direction @ normal) > 1e-6:
        raise ValueError("the matrix is not a shear: it moves points in more than one direction")
    point = -normal * (direction @ m[:3, 3]) / slopes[0]
    return math.atan(slopes[0]), direction, homogeneous(point), normal


def _along(factor: float, direction: Array, fixed: Array) -> Array:
    """Matrix that scales one unit direction, and leaves the plane through `fixed` in place."""
    matrix = np.identity(4)
    matrix[:3, :3] -= (1.0 - factor) * np.outer(direction, direction)
    matrix[:3, 3] = (1.0 - factor) * (fixed @ direction) * direction
    return matrix


def _unit(vector: ArrayLike) -> Array:
    values = np.asarray(vector, dtype=np.float64)[:3]
    return values / np.linalg.norm(values)
