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
from simkit.physics.model import Model
from simkit.physics.plan import Plane, ShapePlan, Solid
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


class Ball(NamedTuple):
    """A ball around a shape, a little larger than needed: what is left over covers rounding."""

    radius: float
    """Its radius [m]."""
    middle: Floats | None = None
    """Its middle in the frame of the shape [m], (3,); None for the origin of the shape."""


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

    @property
    def middle(self) -> Floats:
        """Middle of the ball in the world [m], (3,)."""
        inner = self.ball.middle
        return self.origin if inner is None else self.origin + self.rotation @ inner


class RayShapes:
    """What rays can hit of one model.

    Args:
        model: The model.
    """

    def __init__(self, model: Model) -> None:
        shapes = model.built.shapes
        self.labels = tuple(shapes)
        """Names of its shapes in the engine, in the order of the targets."""
        self._model = model
        self._moves = model.built.skeleton.getNumDofs() > 0
        self._placings = -1
        self._targets: list[Target] = []
        self._shapes = [self._seen(node, plan) for node, plan in shapes.values()]

    def targets(self) -> list[Target]:
        """Its shapes where they are now."""
        if self._moves or self._placings != self._model.placings:
            self._placings = self._model.placings
            self._targets = [self._target(*one) for one in self._shapes]
        return self._targets

    @staticmethod
    def _target(shape: Solid | CollisionMesh, ball: Ball, frame: Any, inner: Any) -> Target:
        pose = frame.getWorldTransform()
        matrix = (pose if inner is None else pose.multiply(inner)).matrix()
        return Target(shape, matrix[:3, :3], matrix[:3, 3], ball)

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
    with np.errstate(divide="ignore", invalid="ignore"):
        for number, rays in _passing(points, ways, targets, (start, reach)):
            target = targets[number]
            turn = target.rotation.T
            away = (points if points.shape[1] == 1 else points.take(rays, 1)) - target.origin[
                :, None
            ]
            local = turn @ ways.take(rays, 1)
            found = start + _hit(target.shape, turn @ away + start * local, local)
            is_first = (found < distances.take(rays)) & (found <= reach)
            first = rays[is_first]
            distances[first], numbers[first] = found[is_first], number
    return Hits(distances, numbers)


def _passing(
    points: Floats, ways: Floats, targets: Sequence[Target], between: tuple[float, float]
) -> Iterator[tuple[int, NDArray[np.intp]]]:
    """Numbers of targets, and of the rays that pass the ball around each between their start and their reach [m]."""
    start, reach = between
    away = np.array([one.middle for one in targets]).reshape(-1, 3, 1) - points
    radii = np.array([one.ball.radius for one in targets]).reshape(-1, 1)
    squares = (away * away).sum(axis=1)
    gaps = np.sqrt(squares)
    near = ((gaps + radii >= start) & (gaps - radii <= reach)).any(axis=1).nonzero()[0]
    away, radii = away[near], radii[near]
    along = away[:, :, 0] @ ways if points.shape[1] == 1 else (away * ways).sum(axis=1)
    passes = along * along >= squares[near] - radii * radii
    passes &= along >= start - radii
    for number, row in zip(near.tolist(), passes, strict=True):
        rays = row.nonzero()[0]
        if rays.size:
            yield number, rays


def ball_around(shape: Solid | CollisionMesh) -> Ball:
    """The ball around a shape."""
    middle, radius = None, math.inf
    match shape:
        case Box():
            radius = math.hypot(*shape.size) / 2.0
        case Cylinder():
            radius = math.hypot(shape.radius, shape.length / 2.0)
        case Sphere():
            radius = shape.radius
        case CollisionMesh():
            middle, radius = shape.middle, shape.radius
    return Ball(radius * 1.001, middle)


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
