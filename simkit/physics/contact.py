"""Contacts: where things touch, and how hard."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from simkit.geometry import Vector
from simkit.physics.engine import vector
from simkit.physics.plan import ShapePlan


@dataclass(frozen=True, slots=True, kw_only=True)
class Side:
    """One of two things that touch."""

    model: str
    """The model."""
    link: str
    """The link of the file that the shape belongs to."""
    body: str
    """The body: another link if a fixed joint holds that one on it."""
    shape: str
    """The collision shape, as Gazebo would call it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact:
    """One point at which two shapes touch."""

    first: Side
    """One of them."""
    second: Side
    """The other."""
    point: Vector
    """Where, in the world [m]."""
    normal: Vector
    """Unit vector in the world, from the second to the first."""
    depth: float
    """How far they reach into each other [m]."""
    force: Vector
    """On the first in the last step, in the world [N]; the second feels the opposite."""


@dataclass(frozen=True, slots=True)
class Owner:
    """What a shape of the engine is."""

    model: str
    """Its model."""
    body: str
    """Its body."""
    plan: ShapePlan
    """What it was made from."""

    @property
    def side(self) -> Side:
        """The same, as a contact says it."""
        return Side(
            model=self.model, link=self.plan.link, body=self.body, shape=self.plan.name
        )  # fmt: skip


def read_contacts(result: Any, owners: Mapping[str, Owner]) -> tuple[Contact, ...]:
    """The contacts of a collision result of the engine, in its order."""
    return tuple(_contact(one, owners) for one in result.getContacts())


def shape_names(contact: Any) -> tuple[str, str]:
    """Names in the engine of the two shapes that touch."""
    one, other = contact.collisionObject1, contact.collisionObject2
    return one.getShapeFrame().getName(), other.getShapeFrame().getName()


def _contact(contact: Any, owners: Mapping[str, Owner]) -> Contact:
    first, second = shape_names(contact)
    return Contact(
        first=owners[first].side,
        second=owners[second].side,
        point=vector(contact.point),
        normal=vector(contact.normal),
        depth=float(contact.penetrationDepth),
        force=vector(contact.force),
    )
