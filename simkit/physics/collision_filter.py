"""Which shapes can touch anything: the engine looks for contacts of no others."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from simkit.physics.contact import Contact, Owner, read_contacts, shape_names
from simkit.physics.engine import dart
from simkit.physics.model import Model
from simkit.physics.reach import Reach, reaches

MARGIN = 0.01
"""Shapes that cannot come nearer to each other do not touch [m]."""


class CollisionFilter:
    """The search for contacts of one world.

    Shapes that can never touch another one are left out of it. So are two that never move, like the
    foot of an arm on the ground: where they touch is looked up once.

    Args:
        engine: The engine's world.
        models: The models of the world; it may change.
        owners: What the engine's shapes are; it may change.
    """

    def __init__(
        self, engine: Any, models: Mapping[str, Model], owners: Mapping[str, Owner]
    ) -> None:
        self.still: tuple[Contact, ...] = ()
        """The contacts of what never moves, as far as the engine does not look for them."""
        self._engine = engine
        self._models = models
        self._owners = owners
        self._left_out: frozenset[str] = frozenset()
        self._seen: tuple[Any, ...] = ()

    def refresh(self) -> None:
        """See who can touch whom; to be called when models came, went, or were put somewhere."""
        # What is free can touch everything wherever it is put; joints do not change how far a model reaches.
        placed = tuple((one, 0 if one.is_free else one.placings) for one in self._models.values())
        if placed == self._seen:
            return
        self._seen = placed
        left_out = self._idle()
        if left_out or self._left_out:
            self._look_only(left_out)
        self._left_out = left_out

    def forget(self, model: Model) -> None:
        """Look for no contacts of a model that is about to go: the engine only drops shapes that it has found itself."""
        group = self._engine.getConstraintSolver().getCollisionGroup()
        group.update()
        for node, _ in model.built.shapes.values():
            group.removeShapeFrame(node)

    def all_contacts(self) -> tuple[Contact, ...]:
        """What touches as things stand now, whether the engine looks for it or not; the forces are zero."""
        return tuple(contact for _, contact in self._all())

    def _idle(self) -> frozenset[str]:
        """Labels of the shapes that can touch nothing that matters."""
        shapes = [one for model in self._models.values() for one in _shapes_of(model)]
        movers = [one for one in shapes if not one.reach.is_still]
        if any(math.isinf(one.reach.region.radius) for one in movers):
            return frozenset()  # what can go anywhere can touch everything
        return frozenset(
            one.label
            for one in shapes
            if not any(one.may_touch(other) for other in (movers if one.reach.is_still else shapes))
        )

    def _look_only(self, left_out: frozenset[str]) -> None:
        """Let the engine look for the contacts of all shapes but some, always in the same order."""
        solver = self._engine.getConstraintSolver()
        solver.clearLastCollisionResult()  # it would point to what the group forgets
        group = solver.getCollisionGroup()
        group.update()
        shapes = self._nodes()
        for _, node in shapes:
            group.removeShapeFrame(node)
        for label, node in shapes:
            if label not in left_out:
                group.addShapeFrame(node)
        found = self._all() if left_out else []
        self.still = tuple(one for names, one in found if not left_out.isdisjoint(names))

    def _nodes(self) -> list[tuple[str, Any]]:
        """All shapes of the engine, by their labels."""
        return [
            (label, node)
            for model in self._models.values()
            for label, (node, _) in model.built.shapes.items()
        ]

    def _all(self) -> list[tuple[tuple[str, str], Contact]]:
        """The contacts of all shapes with their labels, found in a group apart: the engine keeps its last result."""
        collision = dart().collision
        solver = self._engine.getConstraintSolver()
        group = solver.getCollisionDetector().createCollisionGroup()
        for _, node in self._nodes():
            group.addShapeFrame(node)
        result = collision.CollisionResult()
        filter_ = solver.getCollisionOption().collisionFilter
        group.collide(collision.CollisionOption(True, 1000, filter_), result)
        names = [shape_names(one) for one in result.getContacts()]
        return list(zip(names, read_contacts(result, self._owners), strict=True))


@dataclass(frozen=True, slots=True)
class _Shape:
    """One shape of a model."""

    label: str
    """Its name in the engine."""
    model: str
    touches_its_model: bool
    """Whether it may touch others of its model."""
    reach: Reach

    def may_touch(self, other: _Shape) -> bool:
        if self.label == other.label or (self.model == other.model and not self.touches_its_model):
            return False
        return self.reach.may_touch(other.reach, MARGIN)


def _shapes_of(model: Model) -> Iterator[_Shape]:
    touches_itself = any(body.self_collide for body in model.plan.bodies.values())
    for body, number, reach in reaches(model.plan, model.base):
        yield _Shape(f"{model.name}::{body}::{number}", model.name, touches_itself, reach)
