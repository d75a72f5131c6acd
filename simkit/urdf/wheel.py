"""Wheels: which shapes roll, and how large they are."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TypeVar

from simkit.geometry import Transform, Vector
from simkit.urdf.model import Cylinder, Sphere

ASKEW = math.radians(2.0)
"""By so much the axis of a wheel may be off that of its joint: numbers like 1.57 are rounded [rad]."""
OFF_CENTRE = 0.05
"""Share of its radius by which the centre of a wheel may be off the axis of its joint."""
LONGEST = 2.0
"""A wheel is no longer than so many radii; what is longer is a roller."""

Shape = TypeVar("Shape")


def is_wheel(shape: Cylinder, frame: Transform, *, axis: Vector, origin: Vector) -> bool:
    """Whether a cylinder that turns about an axis turns about its own, and is as short as a wheel.

    Args:
        shape: The cylinder.
        frame: Where it stands.
        axis: What it turns about, of any length, in the frame that `frame` is known in.
        origin: A point of the axis, in the same frame [m].
    """
    length = math.hypot(*axis)
    if shape.length > LONGEST * shape.radius or not length:
        return False
    x, y, z = (value / length for value in axis)
    own = frame.rotate((0.0, 0.0, 1.0))
    if abs(x * own[0] + y * own[1] + z * own[2]) < math.cos(ASKEW):
        return False
    arm = [c - o for c, o in zip(frame.translation, origin, strict=True)]
    forward = x * arm[0] + y * arm[1] + z * arm[2]
    off = math.dist(arm, (forward * x, forward * y, forward * z))
    return off <= OFF_CENTRE * shape.radius


def round_part(
    shapes: Iterable[tuple[Shape, Transform]],
) -> tuple[Cylinder | Sphere, Transform] | None:
    """The first round shape among those of a wheel, with where it stands; None if there is none."""
    for shape, frame in shapes:
        if isinstance(shape, Cylinder | Sphere):
            return shape, frame
    return None
