"""What watchers are and look at: a model, the ground below it, and what it touches."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import TypeAlias

from simkit.gazebo.models import Spawned
from simkit.gazebo.server import Gazebo
from simkit.gazebo.watchers.motion import Motion, drive_of
from simkit.geometry import Vector
from simkit.physics import Model, Plane, World
from simkit.urdf.placed_shape import PlacedShape


class WatchedModel:
    """What watchers look at: a model, and the world around it.

    Args:
        gazebo: The world, and its node.
        spawned: The model.
    """

    def __init__(self, gazebo: Gazebo, spawned: Spawned) -> None:
        self.gazebo = gazebo
        self.spawned = spawned
        self.model = spawned.model
        drive = drive_of(spawned)
        self.motion = None if drive is None else Motion(drive)
        """Its driven wheels, and what it did in the last looks; None if it has none."""


class Hint(str):
    """Something that may well be meant so."""

    __slots__ = ()


Looks: TypeAlias = Iterator[str | None]
"""One look each: what is wrong, with numbers, and what would be right; None for nothing yet. The first one is right after
spawning, the others follow every 0.1 s that the world moves, until it has spoken or ends."""


@dataclass(frozen=True, kw_only=True)
class Watcher:
    """A generator that watches one model for one kind of fault."""

    rule: str
    """Id of the fault, as `check_urdf` has it."""
    looks: Callable[[WatchedModel], Looks]
    """What it does, look by look; nothing for a model that cannot have the fault."""
    is_said_by_rule: bool
    """Whether it says what `check_urdf` says under this id; then it is silent if that has warned."""


def watcher(
    rule: str, *, is_said_by_rule: bool = False
) -> Callable[[Callable[[WatchedModel], Looks]], Watcher]:
    """Make a watcher of a generator: a decorator."""
    return lambda looks: Watcher(rule=rule, looks=looks, is_said_by_rule=is_said_by_rule)


def drive_watcher(
    rule: str, *, is_said_by_rule: bool = False
) -> Callable[[Callable[[WatchedModel, Motion], Looks]], Watcher]:
    """The same for what has wheels, and can go anywhere."""

    def made(looks: Callable[[WatchedModel, Motion], Looks]) -> Watcher:
        def of_wheels(scene: WatchedModel) -> Looks:
            if scene.motion is not None and scene.model.is_free:
                yield from looks(scene, scene.motion)

        return Watcher(rule=rule, looks=of_wheels, is_said_by_rule=is_said_by_rule)

    return made


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
