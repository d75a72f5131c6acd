"""Rays: how far many of them go before they hit something, all at once.

A laser of 720 beams is a few array operations for each shape in its way, not 720 questions to the
engine. Distances are computed from the formula of each shape. A ray that starts inside of a shape
hits it from within, as in Gazebo.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from simkit.physics.engine import isometry
from simkit.physics.mesh import CollisionMesh
from simkit.physics.plan import Plane, ShapePlan, Solid
from simkit.physics.ray_solids import (
    Floats,
    hit_box,
    hit_cylinder,
    hit_plane,
    hit_sphere,
    hit_triangles,
)
from simkit.physics.skeleton import Built
from simkit.urdf.model import Box, Cylinder, Sphere

MISS = -1
"""Number of the target of a ray that hits nothing."""


class Ball(NamedTuple):
    """A ball around a shape, a little larger than needed: what is left over covers rounding."""

    middle: Floats
    """Its middle in the frame of the shape [m], (3,)."""
    radius: float
    """Its radius [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class Target:
    """A shape in the way of rays."""

    shape: Solid | CollisionMesh
    """Its shape."""
    rotation: Floats
    """R_world_shape, (3, 3)."""
    origin: Floats
    """Origin of the shape in the world [m], (3,)."""
    ball: Ball
    """What a ray passes that hits it."""


class RayShapes:
    """What rays can hit of one model.

    Args:
        built: The model in the engine.
    """

    def __init__(self, built: Built) -> None:
        self.labels = tuple(built.shapes)
        """Names of its shapes in the engine, in the order of the targets."""
        self._shapes = [self._seen(node, plan) for node, plan in built.shapes.values()]

    def targets(self) -> Iterator[Target]:
        """Its shapes where they are now."""
        for shape, ball, frame, inner in self._shapes:
            pose = frame.getWorldTransform()
            matrix = (pose if inner is None else pose.multiply(inner)).matrix()
            yield Target(shape, matrix[:3, :3], matrix[:3, 3], ball)

    @staticmethod
    def _seen(node: Any, plan: ShapePlan) -> tuple[Any, Ball, Any, Any]:
        """What is seen, its ball, the frame of the engine that it is known in, and where it is there."""
        if plan.mesh is None:
            return plan.solid, ball_around(plan.solid), node, None
        frame = node.getBodyNodePtr()
        return plan.mesh, ball_around(plan.mesh), frame, isometry(plan.mesh_frame)


@dataclass(frozen=True, slots=True, eq=False)
class Hits:
    """What rays hit."""

    distances: Floats
    """Distance from the start of each ray to what it hits first [m], (n,); inf if it hits nothing."""
    targets: NDArray[np.intp]
    """Number of the target that each ray hits, (n,); -1 if none."""


def cast(
    origins: Floats,
    directions: Floats,
    *,
    targets: Sequence[Target],
    reach: float = math.inf,
    start: float = 0.0,
) -> Hits:
    """Cast rays.

    Args:
        origins: Where they come from in the world [m], (n, 3), or (3,) for all.
        directions: Unit vectors in the world, (n, 3).
        targets: What they may hit.
        reach: What is farther away from the origin is not hit [m].
        start: They begin so far from their origin [m].
    """
    ways = np.ascontiguousarray(np.asarray(directions, dtype=np.float64).T)
    points = np.ascontiguousarray(np.atleast_2d(np.asarray(origins, dtype=np.float64)).T)
    distances = np.full(ways.shape[1], np.inf)
    numbers = np.full(ways.shape[1], MISS, dtype=np.intp)
    for number, passes in enumerate(_passing(points, ways, targets, reach)):
        near: Any = slice(None) if passes.all() else np.flatnonzero(passes)
        target = targets[number]
        turn = target.rotation.T
        away = (points if points.shape[1] == 1 else points[:, near]) - target.origin[:, None]
        local = turn @ ways[:, near]
        if not local.size:
            continue
        found = start + _hit(target.shape, turn @ away + start * local, local)
        is_first = (found < distances[near]) & (found <= reach)
        distances[near] = np.where(is_first, found, distances[near])
        numbers[near] = np.where(is_first, number, numbers[near])
    return Hits(distances, numbers)


def _passing(
    points: Floats, ways: Floats, targets: Sequence[Target], reach: float
) -> NDArray[np.bool_]:
    """Whether a ray passes the ball around a target within reach: (targets, rays)."""
    middles = np.array([one.origin + one.rotation @ one.ball.middle for one in targets])
    radii = np.array([one.ball.radius for one in targets])[:, None]
    if points.shape[1] == 1:
        away = middles.reshape(-1, 3) - points.T
        along = away @ ways
        squares = (away * away).sum(axis=1)[:, None]
    else:
        away = middles.reshape(-1, 3, 1) - points
        along = (away * ways).sum(axis=1)
        squares = (away * away).sum(axis=1)
    passes: NDArray[np.bool_] = along * along >= squares - radii * radii
    passes &= along >= -radii
    passes &= along <= reach + radii
    return passes


def ball_around(shape: Solid | CollisionMesh) -> Ball:
    """The ball around a shape."""
    middle, radius = np.zeros(3), math.inf
    match shape:
        case Box():
            radius = math.hypot(*shape.size) / 2.0
        case Cylinder():
            radius = math.hypot(shape.radius, shape.length / 2.0)
        case Sphere():
            radius = shape.radius
        case CollisionMesh():
            middle, radius = shape.middle, shape.radius
    return Ball(middle, radius * 1.001)


def _hit(shape: Solid | CollisionMesh, origins: Floats, directions: Floats) -> Floats:
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
        case CollisionMesh():
            return hit_triangles(origins, directions, shape.corners)
