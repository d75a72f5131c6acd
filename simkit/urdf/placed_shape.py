"""A shape that stands somewhere: how far it reaches, how near a point is, whether two of them overlap."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeAlias

from simkit.geometry import Transform, Vector
from simkit.urdf.model import Box, Cylinder, Sphere

Primitive: TypeAlias = Box | Cylinder | Sphere
"""A shape with a formula; a cylinder stands along z."""

_SMALLEST, _LARGEST = 1e-9, 1e6
"Sizes beyond these [m] are no sizes of a robot, and their products would leave the range of numbers."

_ROUNDS = 100
"So many steps decide whether two shapes overlap; a case so close that they do not is no overlap."


class PlacedShape(NamedTuple):
    """A shape in a frame."""

    shape: Primitive
    """Its shape."""
    frame: Transform
    """Where it stands."""

    def seen_from(self, outer: Transform) -> PlacedShape:
        """The same shape in a, for `outer` = T_ab of the frame b that it is known in."""
        return PlacedShape(self.shape, outer @ self.frame)

    def support(self, direction: Vector) -> Vector:
        """The point of it that lies farthest in a direction [m]."""
        local = self.frame.rotate_back(direction)
        return self.frame.apply(_support(self.shape, local))

    def lowest(self) -> float:
        """The z of its lowest point [m]."""
        return self.support((0.0, 0.0, -1.0))[2]

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the point of the shape that is farthest from it [m]."""
        x, y, z = (abs(value) for value in self.frame.apply_back(point))
        match self.shape:
            case Box():
                dx, dy, dz = (side / 2 for side in self.shape.size)
                return math.hypot(x + dx, y + dy, z + dz)
            case Cylinder():
                return math.hypot(math.hypot(x, y) + self.shape.radius, z + self.shape.length / 2)
            case Sphere():
                return math.hypot(x, y, z) + self.shape.radius

    def depth(self, point: Vector) -> float:
        """How deep a point lies below the surface [m]; negative: how far it is away."""
        x, y, z = (abs(value) for value in self.frame.apply_back(point))
        match self.shape:
            case Box():
                dx, dy, dz = (side / 2 for side in self.shape.size)
                return _depth(x - dx, y - dy, z - dz)
            case Cylinder():
                return _depth(math.hypot(x, y) - self.shape.radius, z - self.shape.length / 2)
            case Sphere():
                return self.shape.radius - math.hypot(x, y, z)


def overlap(one: PlacedShape, other: PlacedShape, least: float) -> bool:
    """Whether two shapes reach into each other, by about `least` [m] or more.

    Both are made smaller by that much, and must then still come as near to each other as that. Shapes
    that touch, or reach less deep, do not count.

    Source:
        Frank and Wolfe's method with pairwise steps, on the differences of points of both: it either finds
        a plane between the shapes, or comes as close to a common point as one likes. Lacoste-Julien and
        Jaggi (2015), algorithm 2.
    """
    inner, outer = shrunk(one.shape, least), shrunk(other.shape, least)
    if inner is None or outer is None:
        return False
    one, other = PlacedShape(inner, one.frame), PlacedShape(outer, other.frame)
    x = _minus(one.frame.translation, other.frame.translation)
    weights = {x: 1.0}
    for _ in range(_ROUNDS):
        distance = math.hypot(*x)
        if distance <= least:
            return True
        near = _minus(one.support((-x[0], -x[1], -x[2])), other.support(x))
        far = max(weights, key=lambda corner: _dot(corner, x))
        step = _minus(near, far)
        if _dot(near, x) > least * distance or _dot(step, x) >= 0.0:
            return False
        share = min(weights[far], -_dot(x, step) / _dot(step, step))
        weights[near] = weights.get(near, 0.0) + share
        weights[far] -= share
        if weights[far] <= 0.0:
            del weights[far]
        x = (x[0] + share * step[0], x[1] + share * step[1], x[2] + share * step[2])
    return False


def shrunk(shape: Primitive, by: float) -> Primitive | None:
    """A shape whose surface lies deeper [m] everywhere; None if nothing is left."""
    match shape:
        case Box():
            x, y, z = (side - 2 * by for side in shape.size)
            return Box((x, y, z)) if min(x, y, z) > 0.0 else None
        case Cylinder():
            radius, length = shape.radius - by, shape.length - 2 * by
            return Cylinder(radius, length) if min(radius, length) > 0.0 else None
        case Sphere():
            return Sphere(shape.radius - by) if shape.radius > by else None


def volume(shape: Primitive) -> float:
    """Volume of a shape [m^3]."""
    match shape:
        case Box():
            return math.prod(shape.size)
        case Cylinder():
            return math.pi * shape.radius * shape.radius * shape.length
        case Sphere():
            return 4.0 / 3.0 * math.pi * shape.radius * shape.radius * shape.radius


def extent(shape: Primitive) -> float:
    """The longest straight line that fits into a shape [m]."""
    match shape:
        case Box():
            return math.hypot(*shape.size)
        case Cylinder():
            return math.hypot(2 * shape.radius, shape.length)
        case Sphere():
            return 2 * shape.radius


def is_sound(shape: Primitive) -> bool:
    """Whether all its sizes are positive, and of this world."""
    match shape:
        case Box():
            sizes: tuple[float, ...] = shape.size
        case Cylinder():
            sizes = (shape.radius, shape.length)
        case Sphere():
            sizes = (shape.radius,)
    return all(_SMALLEST < size < _LARGEST for size in sizes)


def _support(shape: Primitive, direction: Vector) -> Vector:
    x, y, z = direction
    match shape:
        case Box():
            a, b, c = shape.size
            return (math.copysign(a / 2, x), math.copysign(b / 2, y), math.copysign(c / 2, z))
        case Cylinder():
            across = math.hypot(x, y)
            scale = shape.radius / across if across > 0.0 else 0.0
            return (scale * x, scale * y, math.copysign(shape.length / 2, z))
        case Sphere():
            length = math.hypot(x, y, z)
            scale = shape.radius / length if length > 0.0 else 0.0
            return (scale * x, scale * y, scale * z)


def _depth(*beyond: float) -> float:
    """Depth in a shape, of how far a point is beyond each pair of its faces."""
    outside = math.hypot(*(max(0.0, value) for value in beyond))
    return -outside if outside > 0.0 else -max(beyond)


def _minus(left: Vector, right: Vector) -> Vector:
    return (left[0] - right[0], left[1] - right[1], left[2] - right[2])


def _dot(left: Vector, right: Vector) -> float:
    return left[0] * right[0] + left[1] * right[1] + left[2] * right[2]
