"""Rays: how far many of them go before they hit something, all at once.

A laser of 720 beams is a few array operations for each shape in its way, not 720 questions to the
engine. Distances are computed from the formula of each shape. A ray that starts inside of a shape
hits it from within, as in Gazebo.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from simkit.physics.mesh import TriangleMesh
from simkit.physics.plan import Plane, Solid
from simkit.physics.ray_solids import (
    Floats,
    hit_box,
    hit_cylinder,
    hit_plane,
    hit_sphere,
    hit_triangles,
)
from simkit.urdf.model import Box, Cylinder, Sphere

MISS = -1
"""Number of the target of a ray that hits nothing."""


@dataclass(frozen=True, slots=True, eq=False)
class Target:
    """A shape in the way of rays."""

    shape: Solid | TriangleMesh
    """Its shape."""
    rotation: Floats
    """R_world_shape, (3, 3)."""
    origin: Floats
    """Origin of the shape in the world [m], (3,)."""


@dataclass(frozen=True, slots=True, eq=False)
class Hits:
    """What rays hit."""

    distances: Floats
    """Distance from the start of each ray to what it hits first [m], (n,); inf if it hits nothing."""
    targets: NDArray[np.intp]
    """Number of the target that each ray hits, (n,); -1 if none."""


def cast(
    origins: Floats, directions: Floats, *, targets: Sequence[Target], reach: float = math.inf
) -> Hits:
    """Cast rays.

    Args:
        origins: Where they start in the world [m], (n, 3), or (3,) for all.
        directions: Unit vectors in the world, (n, 3).
        targets: What they may hit.
        reach: What is farther away is not hit [m].
    """
    ways = np.ascontiguousarray(np.asarray(directions, dtype=np.float64).T)
    starts = np.ascontiguousarray(np.atleast_2d(np.asarray(origins, dtype=np.float64)).T)
    distances = np.full(ways.shape[1], np.inf)
    numbers = np.full(ways.shape[1], MISS, dtype=np.intp)
    for number, passes in enumerate(_passing(starts, ways, targets, reach)):
        near = np.flatnonzero(passes)
        if not near.size:
            continue
        target = targets[number]
        turn = target.rotation.T
        away = (starts if starts.shape[1] == 1 else starts[:, near]) - target.origin[:, None]
        found = _hit(target.shape, turn @ away, turn @ ways[:, near])
        is_first = (found < distances[near]) & (found <= reach)
        first = near[is_first]
        distances[first] = found[is_first]
        numbers[first] = number
    return Hits(distances, numbers)


def _passing(
    starts: Floats, ways: Floats, targets: Sequence[Target], reach: float
) -> NDArray[np.bool_]:
    """Whether a ray passes the ball around a target within reach: (targets, rays)."""
    balls = [_ball(target) for target in targets]
    middles = np.array([middle for middle, _ in balls]).reshape(-1, 3)
    radii = np.array([radius for _, radius in balls])[:, None]
    along = middles @ ways - (starts * ways).sum(axis=0)
    squares = (middles * middles).sum(axis=1)[:, None] + (starts * starts).sum(axis=0)
    aside = squares - 2.0 * (middles @ starts) - along * along
    passes: NDArray[np.bool_] = (aside <= radii * radii) & (along >= -radii)
    passes &= along - radii <= reach
    return passes


def _ball(target: Target) -> tuple[Floats, float]:
    """A ball around a shape, a little larger than needed: its middle in the world, and its radius [m].

    What is left over covers the rounding of coordinates of kilometres.
    """
    match target.shape:
        case Box():
            radius = float(np.linalg.norm(target.shape.size)) / 2.0
        case Cylinder():
            radius = float(np.hypot(target.shape.radius, target.shape.length / 2.0))
        case Sphere():
            radius = target.shape.radius
        case Plane():
            radius = float("inf")
        case TriangleMesh():
            return (
                target.origin + target.rotation @ target.shape.middle,
                target.shape.radius * 1.001,
            )
    return target.origin, radius * 1.001


def _hit(shape: Solid | TriangleMesh, origins: Floats, directions: Floats) -> Floats:
    match shape:
        case Box():
            x, y, z = shape.size
            return hit_box(origins, directions, (x / 2.0, y / 2.0, z / 2.0))
        case Cylinder():
            return hit_cylinder(origins, directions, shape.radius, shape.length / 2.0)
        case Sphere():
            return hit_sphere(origins, directions, shape.radius)
        case Plane():
            return hit_plane(origins, directions, shape.normal)
        case TriangleMesh():
            return hit_triangles(origins, directions, shape.corners)
