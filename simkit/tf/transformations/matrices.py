"""Homogeneous matrices: identity, translation, product, inverse, comparison."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.vectors import Array


def identity_matrix() -> Array:
    """The matrix (4, 4) that changes nothing."""
    return np.identity(4)


def translation_matrix(direction: ArrayLike) -> Array:
    """Matrix (4, 4) that moves by the vector `direction` (3,) [m]."""
    matrix = np.identity(4)
    matrix[:3, 3] = np.asarray(direction, dtype=np.float64)[:3]
    return matrix


def translation_from_matrix(matrix: ArrayLike) -> Array:
    """The vector (3,) [m] by which a matrix (4, 4) moves the origin."""
    return np.array(matrix, dtype=np.float64)[:3, 3].copy()


def inverse_matrix(matrix: ArrayLike) -> Array:
    """The inverse (4, 4) of any transformation."""
    return np.linalg.inv(np.asarray(matrix, dtype=np.float64))


def concatenate_matrices(*matrices: ArrayLike) -> Array:
    """The product of the matrices: the last one acts first."""
    product = np.identity(4)
    for matrix in matrices:
        product = product @ np.asarray(matrix, dtype=np.float64)
    return product


def is_same_transform(matrix0: ArrayLike, matrix1: ArrayLike) -> bool:
    """Whether two matrices (4, 4) do the same; a common factor makes no difference."""
    first, second = (np.asarray(m, dtype=np.float64) for m in (matrix0, matrix1))
    return bool(np.allclose(first / first[3, 3], second / second[3, 3]))
