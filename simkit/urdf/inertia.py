"""Mass and inertia of rigid bodies: of simple shapes, of what is lumped together, and what is possible at all.

Matrices of 3 by 3 are tuples of rows: numpy takes longer to load than a robot to check.

All tensors are about the centre of mass of their body [kg m^2], in the axes of the frame that is named.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.geometry import IDENTITY_MATRIX, Matrix, Transform, Vector
from simkit.urdf.model import Box, Cylinder, Sphere
from simkit.urdf.placed_shape import PlacedShape, Primitive, volume

ROUNDED = 0.01
"""Tensors are written with few digits: the triangle inequality may be broken by so much."""

_FLAT = 1e-9
"A principal moment that is smaller than this share of the largest one is as good as zero."

_SWEEPS = 30
"Jacobi needs about five; numbers that are not finite never get there."


def diagonal_matrix(entries: Vector) -> Matrix:
    """The matrix with these entries on its diagonal."""
    a, b, c = entries
    return ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c))


def transpose(matrix: Matrix) -> Matrix:
    """Rows for columns: of a rotation its inverse."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return ((a, d, g), (b, e, h), (c, f, i))


def apply(matrix: Matrix, vector: Vector) -> Vector:
    """The product of a matrix and a column."""
    x, y, z = vector
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)


def product(left: Matrix, right: Matrix) -> Matrix:
    """The product of two matrices: for rotations R_ac = R_ab R_bc."""
    columns = transpose(right)
    return transpose((apply(left, columns[0]), apply(left, columns[1]), apply(left, columns[2])))


def added(left: Matrix, right: Matrix) -> Matrix:
    """The sum of two matrices."""
    (a, b, c), (d, e, f), (g, h, i) = left
    (j, k, m), (n, o, p), (q, r, s) = right
    return ((a + j, b + k, c + m), (d + n, e + o, f + p), (g + q, h + r, i + s))


def eigenvalues(matrix: Matrix) -> Vector:
    """The three eigenvalues of a symmetric matrix, the smallest first.

    Source:
        Jacobi's rotations, which also find the small ones of a matrix of uneven size.
    """
    turned = matrix
    for _ in range(_SWEEPS):
        if turned[0][1] == turned[0][2] == turned[1][2] == 0.0:
            break
        for row, column in ((0, 1), (0, 2), (1, 2)):
            turned = _without(turned, row, column)
    low, middle, high = sorted((turned[0][0], turned[1][1], turned[2][2]))
    return (low, middle, high)


def _without(matrix: Matrix, row: int, column: int) -> Matrix:
    """The same matrix in axes that are turned so that one entry beside the diagonal is gone."""
    entry = matrix[row][column]
    if entry == 0.0:
        return matrix
    angle = 0.5 * math.atan2(2.0 * entry, matrix[column][column] - matrix[row][row])
    cos, sin = math.cos(angle), math.sin(angle)
    turn = [list(line) for line in IDENTITY_MATRIX]
    turn[row][row] = turn[column][column] = cos
    turn[row][column], turn[column][row] = sin, -sin
    rotation = tuple(tuple(line) for line in turn)
    done = product(transpose(rotation), product(matrix, rotation))  # type: ignore[arg-type]
    cleared = [list(line) for line in done]
    cleared[row][column] = cleared[column][row] = 0.0
    return tuple(tuple(line) for line in cleared)  # type: ignore[return-value]


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
            return diagonal_matrix((mass * (y + z) / 12, mass * (x + z) / 12, mass * (x + y) / 12))
        case Cylinder():
            r_r, h_h = shape.radius * shape.radius, shape.length * shape.length
            across = mass * (3 * r_r + h_h) / 12
            return diagonal_matrix((across, across, mass * r_r / 2))
        case Sphere():
            about_any = 2 * mass * shape.radius * shape.radius / 5
            return diagonal_matrix((about_any, about_any, about_any))


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


def placed_body(body: Body, frame: Transform) -> Body:
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
    tensor = diagonal_matrix((0.0, 0.0, 0.0))
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
    return placed_body(Body(mass, (0.0, 0.0, 0.0), shape_tensor(shape.shape, mass)), shape.frame)


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
