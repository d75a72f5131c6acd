"""Random rotations and vectors, from numpy's global generator.

That generator is what tf uses; in a node process it is seeded from the simulation's seed and
the node's name. Nothing else in simkit calls these functions.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.quaternions import quaternion_matrix
from simkit.tf.transformations.vectors import Array


def random_quaternion(rand: ArrayLike | None = None) -> Array:
    """Unit quaternion (4,), every rotation being equally likely.

    Args:
        rand: Three numbers from 0 to 1; drawn if None.

    Source:
        Shoemake, Uniform random rotations, 1992: two angles and one radius.
    """
    u0, u1, u2 = np.random.random(3) if rand is None else np.asarray(rand, dtype=np.float64)[:3]
    inner, outer = math.sqrt(1.0 - u0), math.sqrt(u0)
    a, b = 2.0 * math.pi * u1, 2.0 * math.pi * u2
    return np.array(
        [inner * math.sin(a), inner * math.cos(a), outer * math.sin(b), outer * math.cos(b)]
    )


def random_rotation_matrix(rand: ArrayLike | None = None) -> Array:
    """Rotation matrix (4, 4), every rotation being equally likely."""
    return quaternion_matrix(random_quaternion(rand))


def random_vector(size: int | tuple[int, ...]) -> Any:
    """Array of the given shape, of numbers from 0 to 1."""
    return np.random.random(size)
