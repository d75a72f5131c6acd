"""Lengths and directions."""

from __future__ import annotations

from typing import Any, Final, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array: TypeAlias = NDArray[np.float64]

EPS: Final = 4.0 * float(np.finfo(float).eps)
"Below this a length counts as zero."


def vector_norm(data: ArrayLike, axis: int | None = None, out: Array | None = None) -> Any:
    """Euclidean length of a vector, or of the vectors along `axis`.

    Returns:
        A float if `axis` is None, else an array; None if the result went into `out`.
    """
    squares = np.square(np.asarray(data, dtype=np.float64))
    if out is not None:
        np.sqrt(squares.sum(axis=axis), out=out)
        return None
    lengths = np.sqrt(squares.sum(axis=axis))
    return float(lengths) if lengths.ndim == 0 else lengths


def unit_vector(data: ArrayLike, axis: int | None = None, out: Array | None = None) -> Any:
    """The vector divided by its length; by the lengths along `axis` if that is given.

    Returns:
        A new array; None if the result went into `out`.
    """
    values = np.array(data, dtype=np.float64)
    lengths = np.sqrt(np.square(values).sum(axis=axis, keepdims=axis is not None))
    if out is None:
        return values / lengths
    out[...] = values / lengths
    return None


def normal_of_rank_one(matrix: Array) -> Array:
    """Unit vector n (3,) of a matrix c n nᵀ (3, 3); the zero matrix gives the x axis."""
    column = matrix[:, int(np.argmax(np.square(matrix).sum(axis=0)))]
    length = np.linalg.norm(column)
    return column / length if length > EPS else np.array([1.0, 0.0, 0.0])


def homogeneous(point: ArrayLike) -> Array:
    """The point (3,) with a 1 behind (4,)."""
    return np.append(np.asarray(point, dtype=np.float64)[:3], 1.0)
