"""Rotations and homogeneous matrices under the names of ROS 1's `tf.transformations`.

Points are columns, so `M = concatenate_matrices(T, R)` turns first and moves then; a matrix is
4x4 with the translation [m] in its last column. Quaternions are (x, y, z, w). Angles are
radians. Euler angles are given for one of 24 axis sequences: `sxyz`, the default, turns about
the fixed axes x, y, z in this order (roll, pitch, yaw); `r` instead of `s` turns with the body.

The package `transformations` computes; its author wrote tf's copy too. Three things are tf's here:
the order of a quaternion (the package begins with w), arguments that the package wants by
keyword, and chance from numpy's global generator, which a node process seeds from the
simulation's seed and the node's name.

Source: the names, arguments and kinds of result are those of tf 1.13.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray
from transformations import transformations as w_first

from simkit.errors import UnknownNameError

__all__ = [
    "Arcball",
    "arcball_constrain_to_axis",
    "arcball_map_to_sphere",
    "arcball_nearest_axis",
    "clip_matrix",
    "compose_matrix",
    "concatenate_matrices",
    "decompose_matrix",
    "euler_from_matrix",
    "euler_from_quaternion",
    "euler_matrix",
    "identity_matrix",
    "inverse_matrix",
    "is_same_transform",
    "orthogonalization_matrix",
    "projection_from_matrix",
    "projection_matrix",
    "quaternion_about_axis",
    "quaternion_conjugate",
    "quaternion_from_euler",
    "quaternion_from_matrix",
    "quaternion_inverse",
    "quaternion_matrix",
    "quaternion_multiply",
    "quaternion_slerp",
    "random_quaternion",
    "random_rotation_matrix",
    "random_vector",
    "reflection_from_matrix",
    "reflection_matrix",
    "rotation_from_matrix",
    "rotation_matrix",
    "scale_from_matrix",
    "scale_matrix",
    "shear_from_matrix",
    "shear_matrix",
    "superimposition_matrix",
    "translation_from_matrix",
    "translation_matrix",
    "unit_vector",
    "vector_norm",
]

Array: TypeAlias = NDArray[np.float64]

Axes: TypeAlias = str | tuple[int, int, int, int]
"""A sequence as text (`sxyz`), or as (first axis, odd, repeated, rotating) in fixed-axes order."""

_SEQUENCES: dict[str, tuple[int, int, int, int]] = w_first._AXES2TUPLE


def _of_package(name: str) -> Any:
    """The package's function as it is in tf: in Python. Its twin in C, if there is one, hides it."""
    return getattr(w_first, f"{name}_py", None) or getattr(w_first, name)


arcball_constrain_to_axis = _of_package("arcball_constrain_to_axis")
arcball_map_to_sphere = _of_package("arcball_map_to_sphere")
arcball_nearest_axis = _of_package("arcball_nearest_axis")
compose_matrix = _of_package("compose_matrix")
concatenate_matrices = _of_package("concatenate_matrices")
decompose_matrix = _of_package("decompose_matrix")
identity_matrix = _of_package("identity_matrix")
inverse_matrix = _of_package("inverse_matrix")
is_same_transform = _of_package("is_same_transform")
orthogonalization_matrix = _of_package("orthogonalization_matrix")
projection_matrix = _of_package("projection_matrix")
reflection_from_matrix = _of_package("reflection_from_matrix")
reflection_matrix = _of_package("reflection_matrix")
rotation_from_matrix = _of_package("rotation_from_matrix")
rotation_matrix = _of_package("rotation_matrix")
scale_from_matrix = _of_package("scale_from_matrix")
scale_matrix = _of_package("scale_matrix")
shear_from_matrix = _of_package("shear_from_matrix")
shear_matrix = _of_package("shear_matrix")
translation_from_matrix = _of_package("translation_from_matrix")
translation_matrix = _of_package("translation_matrix")


def _from_xyzw(quaternion: ArrayLike) -> Array:
    return np.roll(np.asarray(quaternion, dtype=np.float64)[:4], 1)


def _to_xyzw(quaternion: Array) -> Array:
    return np.roll(quaternion, -1)


def _sequence(axes: Axes) -> tuple[int, int, int, int]:
    """The sequence as numbers.

    Raises:
        UnknownNameError: There is none of this name (a KeyError, as in tf).
    """
    found = _SEQUENCES.get(axes.lower()) if isinstance(axes, str) else axes
    if found is None or found not in _SEQUENCES.values():
        raise UnknownNameError("axis sequence", str(axes), _SEQUENCES)
    return found


def euler_matrix(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Array:
    """Rotation matrix (4, 4) of three angles [rad]."""
    return _of_package("euler_matrix")(ai, aj, ak, _sequence(axes))


def euler_from_matrix(matrix: ArrayLike, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Angles [rad] of a rotation matrix (4, 4) or (3, 3); one solution of two."""
    return _of_package("euler_from_matrix")(matrix, _sequence(axes))


def euler_from_quaternion(quaternion: ArrayLike, axes: Axes = "sxyz") -> tuple[float, float, float]:
    """Angles [rad] of a quaternion (4,)."""
    return euler_from_matrix(quaternion_matrix(quaternion), axes)


def quaternion_from_euler(ai: float, aj: float, ak: float, axes: Axes = "sxyz") -> Array:
    """Unit quaternion (4,) of three angles [rad]."""
    return _to_xyzw(_of_package("quaternion_from_euler")(ai, aj, ak, _sequence(axes)))


def quaternion_about_axis(angle: float, axis: ArrayLike) -> Array:
    """Quaternion (4,) of a turn by `angle` [rad] about `axis` (3,), of any length."""
    return _to_xyzw(_of_package("quaternion_about_axis")(angle, axis))


def quaternion_matrix(quaternion: ArrayLike) -> Array:
    """Rotation matrix (4, 4) of a quaternion of any length; of the zero quaternion, identity."""
    return _of_package("quaternion_matrix")(_from_xyzw(quaternion))


def quaternion_from_matrix(matrix: ArrayLike) -> Array:
    """Unit quaternion (4,) of a rotation matrix (4, 4).

    w is positive if the trace of the rotation is, else the largest of x, y, z is: tf's sign.
    """
    m = np.asarray(matrix, dtype=np.float64)
    q = _to_xyzw(_of_package("quaternion_from_matrix")(m, isprecise=True))
    diagonal = np.diagonal(m)[:3]
    leading = 3 if diagonal.sum() > 0.0 else int(np.argmax(diagonal))
    return -q if q[leading] < 0.0 else q


def quaternion_multiply(quaternion1: ArrayLike, quaternion0: ArrayLike) -> Array:
    """Hamilton product (4,): the rotation `quaternion0`, then `quaternion1`."""
    return _to_xyzw(
        _of_package("quaternion_multiply")(_from_xyzw(quaternion1), _from_xyzw(quaternion0))
    )


def quaternion_conjugate(quaternion: ArrayLike) -> Array:
    """The quaternion (4,) with its axis reversed; the inverse of a unit quaternion."""
    return _to_xyzw(_of_package("quaternion_conjugate")(_from_xyzw(quaternion)))


def quaternion_inverse(quaternion: ArrayLike) -> Array:
    """The quaternion (4,) whose product with the given one is (0, 0, 0, 1)."""
    return _to_xyzw(_of_package("quaternion_inverse")(_from_xyzw(quaternion)))


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
    ends = (_from_xyzw(quat0), _from_xyzw(quat1))
    return _to_xyzw(
        _of_package("quaternion_slerp")(*ends, fraction, spin, shortestpath=shortestpath)
    )


def projection_from_matrix(matrix: ArrayLike, pseudo: bool = False) -> tuple[Any, ...]:
    """What `projection_matrix` made a matrix (4, 4) from.

    Returns:
        Point (4,) of the plane, normal (3,), direction (3,) or None, centre of perspective (3,)
        or None, `pseudo`.

    Raises:
        ValueError: The matrix is no projection.
    """
    return _of_package("projection_from_matrix")(matrix, pseudo=pseudo)


def clip_matrix(
    left: float,
    right: float,
    bottom: float,
    top: float,
    near: float,
    far: float,
    perspective: bool = False,
) -> Array:
    """Matrix (4, 4) from a view volume, a box or (in perspective) a frustum, to the cube from -1 to 1.

    Raises:
        ValueError: A border is not less than the opposite one, or the tip is not before `near`.
    """
    volume = (left, right, bottom, top, near, far)
    return _of_package("clip_matrix")(*volume, perspective=perspective)


def superimposition_matrix(
    v0: ArrayLike, v1: ArrayLike, scaling: bool = False, usesvd: bool = True
) -> Array:
    """Matrix (4, 4) that moves the points `v0` as near to `v1` as a rigid motion can.

    The points (3, n) or (4, n) [m] are columns, in the same order; `scaling` allows a factor too.
    """
    points = (np.asarray(v, dtype=np.float64)[:3] for v in (v0, v1))
    return _of_package("affine_matrix_from_points")(
        *points, shear=False, scale=scaling, usesvd=usesvd
    )


def vector_norm(data: ArrayLike, axis: int | None = None, out: Array | None = None) -> Any:
    """Euclidean length of a vector, or of the vectors along `axis`; None if it went into `out`."""
    return _of_package("vector_norm")(np.asarray(data, dtype=np.float64), axis=axis, out=out)


def unit_vector(data: ArrayLike, axis: int | None = None, out: Array | None = None) -> Any:
    """The vector divided by its length, or the lengths along `axis`; None if it went into `out`."""
    return _of_package("unit_vector")(np.asarray(data, dtype=np.float64), axis=axis, out=out)


def random_quaternion(rand: ArrayLike | None = None) -> Array:
    """Unit quaternion (4,), every rotation being equally likely.

    Args:
        rand: Three numbers from 0 to 1; drawn if None.
    """
    return _to_xyzw(_of_package("random_quaternion")(np.random.random(3) if rand is None else rand))


def random_rotation_matrix(rand: ArrayLike | None = None) -> Array:
    """Rotation matrix (4, 4), every rotation being equally likely."""
    return quaternion_matrix(random_quaternion(rand))


def random_vector(size: int | tuple[int, ...]) -> Any:
    """Array of the given shape, of numbers from 0 to 1."""
    return np.random.random(size)


class Arcball(w_first.Arcball):  # type: ignore[misc]
    """The virtual trackball: turns what a mouse drags over a window into a rotation.

    `place` it in the window, `down` where the mouse button goes down, `drag` where the mouse goes,
    `matrix` for the result; `setaxes` and `setconstrain` keep drags to axes.

    Args:
        initial: Rotation to begin with: a quaternion (4,) or a matrix (4, 4); none if None.
    """

    def __init__(self, initial: ArrayLike | None = None) -> None:
        is_quaternion = initial is not None and np.shape(initial) == (4,)
        super().__init__(_from_xyzw(initial) if is_quaternion and initial is not None else initial)

    def setconstrain(self, constrain: bool) -> None:
        """Keep drags to the axes, or let them free."""
        self.constrain = constrain

    def getconstrain(self) -> bool:
        """Whether drags keep to the axes."""
        return bool(self.constrain)
