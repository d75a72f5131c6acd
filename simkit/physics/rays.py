"""Rays: how far many of them go before they hit something, all at once.

A laser of 720 beams is a few array operations for each shape in its way, not 720 questions to the
engine. Distances are computed from the formula of each shape. A ray that starts inside of a shape
hits it from within, as in Gazebo.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from simkit.geometry import Vector
from simkit.physics.engine import isometry, vector
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

    middle: Vector
    """Middle of the ball in the world [m]."""

    @classmethod
    def at(cls, shape: Solid | CollisionMesh, ball: Ball, matrix: Floats) -> Target:
        """A shape and the ball around it at T_world_shape, (4, 4)."""
        rotation, origin = matrix[:3, :3], matrix[:3, 3]
        inner = ball.middle
        middle = vector(origin if inner is None else origin + rotation @ inner)
        return cls(shape, rotation, origin, ball, middle)

    def is_between(self, origin: Vector, start: float, reach: float) -> bool:
        """Whether something of the ball is so far away from an origin [m]."""
        gap, radius = math.dist(origin, self.middle), self.ball.radius
        return gap + radius >= start and gap - radius <= reach


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
        return Target.at(shape, ball, matrix)

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
    origin: Vector,
    directions: Floats,
    *,
    targets: Sequence[Target],
    reach: float = math.inf,
    start: float = 0.0,
) -> Hits:
    """Cast rays.

    Args:
        origin: Where they come from in the world [m].
        directions: Unit vectors in the world, (n, 3).
        targets: What they may hit.
        reach: What is farther away from the origin is not hit [m].
        start: They begin so far from their origin [m].
    """
    ways = np.ascontiguousarray(directions.T)
    point = np.array(origin)[:, None]
    distances = np.full(ways.shape[1], np.inf)
    numbers = np.full(ways.shape[1], MISS, dtype=np.intp)
    near = [number for number, one in enumerate(targets) if one.is_between(origin, start, reach)]
    passes = _passing(point, ways, [targets[number] for number in near], start)
    with np.errstate(divide="ignore", invalid="ignore"):
        for number, row in zip(near, passes, strict=True):
            rays, target = row.nonzero()[0], targets[number]
            if not rays.size:
                continue
            turn = target.rotation.T
            local = turn @ ways.take(rays, 1)
            inner = turn @ (point - target.origin[:, None]) + start * local
            found = start + _hit(target.shape, inner, local)
            is_first = (found < distances.take(rays)) & (found <= reach)
            first = rays[is_first]
            distances[first], numbers[first] = found[is_first], number
    return Hits(distances, numbers)


def _passing(
    point: Floats, ways: Floats, targets: Sequence[Target], start: float
) -> NDArray[np.bool_]:
    """Whether a ray passes the ball around a target, beyond its start [m]: (targets, rays)."""
    away = np.array([one.middle for one in targets]).reshape(-1, 3) - point.T
    radii = np.array([one.ball.radius for one in targets])[:, None]
    along = away @ ways
    passes: NDArray[np.bool_] = along * along >= (away * away).sum(axis=1)[:, None] - radii * radii
    passes &= along >= start - radii
    return passes


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
