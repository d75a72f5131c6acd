"""The motion that brings one set of points onto another."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.vectors import Array


def superimposition_matrix(
    v0: ArrayLike,
    v1: ArrayLike,
    scaling: bool = False,
    usesvd: bool = True,  # noqa: ARG001 - tf's choice between two ways to the same matrix
) -> Array:
    """Matrix (4, 4) that moves the points `v0` as near to `v1` as a rigid motion can.

    Args:
        v0: Points (3, n) or (4, n) [m], one per column.
        v1: Where they should be, in the same order.
        scaling: Also scale.
        usesvd: Taken for tf's sake.

    Source:
        Kabsch: the rotation is that of the singular value decomposition of the covariance.
    """
    start, goal = (np.array(v, dtype=np.float64)[:3] for v in (v0, v1))
    start_centre, goal_centre = start.mean(axis=1), goal.mean(axis=1)
    start, goal = start - start_centre[:, None], goal - goal_centre[:, None]
    u, _, vh = np.linalg.svd(goal @ start.T)
    handed = np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ vh))])
    matrix = np.identity(4)
    matrix[:3, :3] = u @ handed @ vh
    if scaling:
        matrix[:3, :3] *= np.sqrt(np.sum(goal**2) / np.sum(start**2))
    matrix[:3, 3] = goal_centre - matrix[:3, :3] @ start_centre
    return matrix
