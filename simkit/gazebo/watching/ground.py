"""How far models are above the floor, or in it; which links touch anything, and what they bear."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from simkit.gazebo.watching.watcher import WatchedModel
from simkit.geometry import Vector
from simkit.physics import Model, Plane, World
from simkit.urdf.placed_shape import PlacedShape


@dataclass(frozen=True, slots=True, kw_only=True)
class Foot:
    """The lowest point of some links."""

    link: str
    """The link that it belongs to."""
    z: float
    """Its height in the world [m]."""
    x: float
    """Where it is in the world [m]."""
    y: float
    """Where it is in the world [m]."""


def floor_height(world: World) -> float | None:
    """Height of the highest level ground [m]; None if the world has none."""
    heights = [
        model.link_pose(shape.link).translation[2]
        for model in world.models.values()
        if model.plan.is_static
        for body in model.plan.bodies.values()
        for shape in body.shapes
        if isinstance(shape.solid, Plane) and shape.solid.normal[2] > 0.999
    ]
    return max(heights, default=None)


def foot(model: Model, *, body: str | None = None) -> Foot | None:
    """The lowest point of a model, or of one of its bodies; None if nothing of it touches anything."""
    feet = []
    for link, shape in _placed_shapes(model, body):
        x, y, z = shape.support((0.0, 0.0, -1.0))
        feet.append(Foot(link=link, x=x, y=y, z=z))
    return min(feet, key=lambda found: found.z, default=None)


def is_inside(model: Model, point: Vector) -> bool:
    """Whether a point of the world is inside of a shape of a model."""
    return any(shape.depth(point) > 0.0 for _, shape in _placed_shapes(model))


def _placed_shapes(model: Model, body: str | None = None) -> Iterator[tuple[str, PlacedShape]]:
    """The shapes of a model, or of one of its bodies, in the world, each with its link; planes are left out."""
    for one in model.plan.bodies.values():
        if body is not None and one.name != body:
            continue
        frame = model.link_pose(one.name)
        for shape in one.shapes:
            if not isinstance(shape.solid, Plane):
                yield shape.link, PlacedShape(shape.solid, frame @ shape.frame)


def load_share(scene: WatchedModel, bodies: Iterable[str]) -> float | None:
    """The share of the weight of a model that some of its bodies bear; None if it weighs nothing.

    Args:
        scene: The model.
        bodies: Names of the bodies.
    """
    model, world = scene.model, scene.gazebo.world
    weight = -model.mass * world.gravity[2]
    if weight <= 0.0:
        return None
    wanted, borne = set(bodies), 0.0
    for contact in world.contacts():
        for side, sign in ((contact.first, 1.0), (contact.second, -1.0)):
            other = contact.second if side is contact.first else contact.first
            if side.model == model.name and other.model != model.name and side.body in wanted:
                borne += sign * contact.force[2]
    return max(0.0, borne) / weight


def touching(scene: WatchedModel) -> set[str]:
    """The bodies of a model that touched something else in the last step."""
    name = scene.model.name
    found = set()
    for contact in scene.gazebo.world.contacts():
        for side, other in ((contact.first, contact.second), (contact.second, contact.first)):
            if side.model == name and other.model != name:
                found.add(side.body)
    return found
