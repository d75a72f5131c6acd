"""Meshes: a laser sees their triangles, the engine gets the simplest solid around them.

A mesh with many flat faces makes the engine slow (a cylinder of 64 sides, standing on its face,
makes 193 contacts and 30 ms a step) and is never quite round. So a mesh is stood in for by the
smallest of box, cylinder and sphere that holds it: a wheel rolls, a body rests on its faces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from simkit.geometry import Matrix, Transform
from simkit.urdf.model import Box, Cylinder, Sphere

MAX_TRIANGLES = 20_000
"""A mesh with more is seen by a laser as the solid that stands in for it."""

_X_UP: Matrix = ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
_Y_UP: Matrix = ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0))
_Z_UP: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass(frozen=True, slots=True, eq=False)
class CollisionMesh:
    """A surface of triangles."""

    corners: NDArray[np.float64]
    """Corners of the triangles [m], (n, 3, 3): triangle, corner, coordinate."""
    middle: NDArray[np.float64]
    """Middle of the box around it [m], (3,)."""
    radius: float
    """Of the ball around that [m]."""

    @classmethod
    def of(cls, corners: NDArray[np.float64]) -> CollisionMesh:
        """The mesh with these corners."""
        points = corners.reshape(-1, 3)
        middle = (points.min(axis=0) + points.max(axis=0)) / 2.0
        radius = float(np.sqrt(((points - middle) ** 2).sum(axis=1)).max())
        return cls(np.ascontiguousarray(corners), middle, radius)


def stand_in(mesh: CollisionMesh) -> tuple[Box | Cylinder | Sphere, Transform]:
    """The smallest of box, cylinder (along x, y, z) and sphere around a mesh, and where it is."""
    points = mesh.corners.reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    middle, size = (low + high) / 2.0, np.maximum(high - low, 1e-4)
    origin = (float(middle[0]), float(middle[1]), float(middle[2]))
    away = points - middle
    found: list[tuple[float, Box | Cylinder | Sphere, Transform]] = [
        (float(np.prod(size)), Box((float(size[0]), float(size[1]), float(size[2]))), Transform(origin))
    ]  # fmt: skip
    for axis, turn in enumerate((_X_UP, _Y_UP, _Z_UP)):
        radius = max(float(np.sqrt((np.delete(away, axis, 1) ** 2).sum(axis=1)).max()), 1e-4)
        length = float(size[axis])
        found.append(
            (
                math.pi * radius**2 * length,
                Cylinder(radius, length),
                Transform.from_matrix(origin, turn),
            )
        )
    radius = max(float(np.sqrt((away**2).sum(axis=1)).max()), 1e-4)
    found.append((4.0 / 3.0 * math.pi * radius**3, Sphere(radius), Transform(origin)))
    _, solid, frame = min(found, key=lambda one: one[0])
    return solid, frame
