"""Tameness: whether the numbers of a model are those of a thing that could be built.

What could not be built may fly apart within a few steps, whatever the engine does; it is looked at
after every step. What could is looked at now and then. The bounds are far from anything real.
"""

from __future__ import annotations

import math

from simkit.geometry import Vector
from simkit.physics.plan import BodyPlan, ModelPlan, Plane
from simkit.physics.solids import sizes_of
from simkit.urdf.matrix import eigenvalues

HEAVIEST = 1e4
"""Mass of the heaviest body of a model over that of the lightest one."""
FLATTEST = 1e-4
"""Smallest principal moment of inertia over the largest one."""
IMPOSSIBLE = 1.5
"""Largest principal moment over the sum of the others: more than 1 is impossible, but written often."""
WIDEST, THINNEST = 50.0, 1e-3
"""Sizes of shapes and distances [m]: with others, it is no robot."""
STIFFEST = 1e5
"""Springs and dampers [N m/rad, N/m, N m s/rad, N s/m]."""


def is_tame(plan: ModelPlan) -> bool:
    """Whether a model could be built."""
    masses = [one.body.mass for one in plan.bodies.values()]
    if masses and max(masses) > HEAVIEST * min(masses):
        return False
    return all(map(_is_body_tame, plan.bodies.values())) and all(
        max(one.stiffness, one.damping) < STIFFEST
        and _is_near(one.frame.translation)
        and _is_near(one.anchor.translation)
        for one in plan.joints.values()
    )


def _is_body_tame(plan: BodyPlan) -> bool:
    low, middle, high = eigenvalues(plan.body.tensor)
    if low < FLATTEST * high or high > IMPOSSIBLE * (low + middle):
        return False
    if not _is_near(plan.body.centre) or high > plan.body.mass * WIDEST**2 or plan.decay > 0.1:
        return False
    return all(
        isinstance(shape.solid, Plane)
        or (min(sizes_of(shape.solid)) > THINNEST and max(sizes_of(shape.solid)) < WIDEST)
        for shape in plan.shapes
    )


def _is_near(place: Vector) -> bool:
    return math.hypot(*place) < WIDEST
