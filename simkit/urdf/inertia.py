"""Mass and inertia of rigid bodies: of simple shapes, of what is lumped together, and what is possible at all.

All tensors are about the centre of mass of their body [kg m^2], in the axes of the frame that is named.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.geometry import Matrix, Transform, Vector
from simkit.urdf.matrix import added, diagonal, eigenvalues, product, transpose
from simkit.urdf.model import Box, Cylinder, Sphere
from simkit.urdf.placed_shape import PlacedShape, Primitive, volume

ROUNDED = 0.01
"""Tensors are written with few digits: the triangle inequality may be broken by so much."""

_FLAT = 1e-9
"A principal moment that is smaller than this share of the largest one is as good as zero."


@dataclass(frozen=True)
class Body:
    """How heavy something is, and how hard to turn, seen from some frame a."""

    mass: float
    """Mass [kg]."""
    centre: Vector
    """Centre of mass in a [m]."""
    tensor: Matrix
    """Inertia about the centre of mass, in the axes of a [kg m^2]."""


def shape_tensor(shape: Primitive, mass: float) -> Matrix:
    """Inertia of a shape that is filled evenly, about its middle, in its own axes [kg m^2].

    Args:
        shape: The shape; a cylinder stands along z.
        mass: Its mass [kg].
    """
    match shape:
        case Box():
            x, y, z = (side * side for side in shape.size)
            return diagonal((mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12))
        case Cylinder():
            r_r, h_h = shape.radius * shape.radius, shape.length * shape.length
            across = mass * (3 * r_r + h_h) / 12
            return diagonal((across, across, mass * r_r / 2))
        case Sphere():
            about_any = 2 * mass * shape.radius * shape.radius / 5
            return diagonal((about_any, about_any, about_any))


def turned(tensor: Matrix, rotation: Matrix) -> Matrix:
    """A tensor known in the axes of b, in the axes of a.

    Args:
        tensor: Inertia in the axes of b.
        rotation: R_ab.
    """
    return product(rotation, product(tensor, transpose(rotation)))


def point_tensor(mass: float, offset: Vector) -> Matrix:
    """Inertia of a point: what the parallel axis theorem adds for an axis that is `offset` [m] away."""
    x, y, z = offset
    return (
        (mass * (y * y + z * z), -mass * x * y, -mass * x * z),
        (-mass * x * y, mass * (x * x + z * z), -mass * y * z),
        (-mass * x * z, -mass * y * z, mass * (x * x + y * y)),
    )


def placed(body: Body, frame: Transform) -> Body:
    """A body known in a frame b, seen from a, for `frame` = T_ab."""
    return Body(body.mass, frame.apply(body.centre), turned(body.tensor, frame.matrix))


def merged(bodies: Sequence[Body]) -> Body:
    """Several bodies as one, all of them and the result in one frame.

    Args:
        bodies: At least one, with a mass that is positive in sum.

    Source:
        What sdformat does with links that fixed joints hold together.
    """
    mass = sum(body.mass for body in bodies)
    cx, cy, cz = (sum(b.mass * b.centre[axis] for b in bodies) / mass for axis in range(3))
    tensor = diagonal((0.0, 0.0, 0.0))
    for body in bodies:
        x, y, z = body.centre
        away = point_tensor(body.mass, (x - cx, y - cy, z - cz))
        tensor = added(tensor, added(body.tensor, away))
    return Body(mass, (cx, cy, cz), tensor)


def body_of_shapes(shapes: Sequence[PlacedShape], mass: float) -> Body:
    """The body that shapes make which are filled evenly with one material.

    Args:
        shapes: At least one, of positive volume, all in one frame; what two of them share counts twice.
        mass: Mass of all together [kg].
    """
    whole = sum(volume(one.shape) for one in shapes)
    return merged([_one_body(one, mass * volume(one.shape) / whole) for one in shapes])


def _one_body(shape: PlacedShape, mass: float) -> Body:
    return placed(Body(mass, (0.0, 0.0, 0.0), shape_tensor(shape.shape, mass)), shape.frame)


def is_positive_definite(tensor: Matrix) -> bool:
    """Whether it takes effort to turn the body about every axis."""
    low, _, high = eigenvalues(tensor)
    return low > _FLAT * high and high > 0.0


def triangle_ratio(tensor: Matrix) -> float:
    """The largest principal moment over the sum of the other two; more than 1 is impossible.

    Of a body with masses m at (x, y, z) in its principal axes, the moments are sums of m (y^2 + z^2),
    m (x^2 + z^2) and m (x^2 + y^2): any two of them hold all that the third one has.
    """
    low, middle, high = eigenvalues(tensor)
    return high / (low + middle) if low + middle > 0.0 else math.inf


def gyration_radius(tensor: Matrix, mass: float) -> float:
    """How far from the centre all mass would lie, on a ring, for the largest principal moment [m]."""
    return math.sqrt(max(0.0, eigenvalues(tensor)[2]) / mass)
