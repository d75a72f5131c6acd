"""Stability: which models can be simulated at all, which need attention in every step, and which have come to no good.

A model that is calm at two looks can be left to the engine until the next one. One that is not, or
could not be built, is looked at after each step: numbers that leave all bounds end the engine, and
this program with it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from simkit.geometry import Vector
from simkit.physics.errors import PhysicsError
from simkit.physics.model import Model
from simkit.physics.plan import BodyPlan, ModelPlan, Plane
from simkit.physics.second_order import SecondOrder
from simkit.physics.shapes import sizes_of
from simkit.urdf.inertia import eigenvalues

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


def is_realistic(plan: ModelPlan) -> bool:
    """Whether a model could be built."""
    masses = [one.body.mass for one in plan.bodies.values()]
    if masses and max(masses) > HEAVIEST * min(masses):
        return False
    return all(map(_is_body_realistic, plan.bodies.values())) and all(
        max(one.stiffness, one.damping) < STIFFEST
        and _is_near(one.frame.translation)
        and _is_near(one.anchor.translation)
        for one in plan.joints.values()
    )


def _is_body_realistic(plan: BodyPlan) -> bool:
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


LOOK_EVERY = 64
"""Steps from one look to the next."""
CALM_SPEED = 50.0
"""A model none of whose coordinates is faster [rad/s or m/s] may be calm,"""
CALM_CHANGE = 1e4
"""if none changes its speed faster [rad/s^2 or m/s^2]."""
BOUNDS = 1e7
"""Coordinates beyond this [rad or m] are lost."""


class LostModelError(PhysicsError):
    """A model whose numbers left all bounds; it was taken out of its world."""

    def __init__(self, model: str, time_ns: int) -> None:
        self.model = model
        self.time_ns = time_ns
        super().__init__(
            f"{model} flew apart at {time_ns * 1e-9:.3f} s and was taken out of the world: its masses, inertias, "
            "springs or efforts are too extreme for the steps of the simulator; check them with check_urdf"
        )


class ModelWatch:
    """One model that moves, as it is watched.

    Args:
        model: The model.
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.second_order = SecondOrder(
            model.plan, model.built, tracking=model.tracking, driven=model.driven
        )
        self._skeleton = model.built.skeleton
        self._is_realistic = is_realistic(model.plan)
        self._is_fresh = True

    @property
    def is_quiet(self) -> bool:
        """Whether the engine can be left alone with it."""
        return self.model.is_calm and not self.model.velocity_decay.is_on

    def start(self) -> None:
        """Something was done to it: anything may happen."""
        self.model.is_calm = False
        self._is_fresh = True
        self.second_order.start()

    def look(self) -> None:
        """See what it does."""
        velocities = self._skeleton.getVelocities().tolist()
        self.second_order.look(velocities)
        self.model.is_calm = self._is_realistic and not self._is_fresh and self._is_slow(velocities)
        self._is_fresh = False

    def _is_slow(self, velocities: Sequence[float]) -> bool:
        changes = self._skeleton.getAccelerations().tolist()
        return all(abs(v) < CALM_SPEED for v in velocities) and all(
            abs(a) < CALM_CHANGE for a in changes
        )

    def is_lost(self) -> bool:
        """Whether its numbers have left all bounds."""
        return not all(abs(q) < BOUNDS for q in self._skeleton.getPositions().tolist())
