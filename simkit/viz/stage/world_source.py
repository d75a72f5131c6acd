"""Where the scenes of a world come from: what physics says at this moment, with contacts and what lasers see."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from simkit.errors import UnknownNameError
from simkit.geometry import Vector
from simkit.physics import Contact, Model
from simkit.viz.draw.letters import abbreviated
from simkit.viz.stage.frames import FramePose, TfScene
from simkit.viz.stage.parts import Marks, Polyline, along
from simkit.viz.stage.scene import LONGEST, Scene
from simkit.viz.stage.world_models import Thing, WorldOfThings
from simkit.viz.stage.world_scene import (
    WORLD,
    Actor,
    WorldSettings,
    link_poses,
    make_actor,
    shape_corners,
    world_scene,
)

CONTACTS: Final = "contacts"
"""Name of the display of contacts."""
SCANS: Final = "scans"
"""Name of the display of what lasers see."""
_CONTACT_COLOR, _SCAN_COLOR = "#0a8f45", "#1f5fe0"
_LONGEST: Final = 1.5
"Longest arrow of a force, in lengths of the arrow for the weight of the heaviest model."
_BARB, _BARB_WIDTH = 0.16, 0.07
"Length and half the width of the head of an arrow, in lengths of the arrow."


class ForceScale:
    """How long the arrow of a force is: that of the weight of the heaviest model is as long as that model.

    Args:
        actors: The models.
        gravity: Acceleration of all that falls [m/s^2].
    """

    def __init__(self, actors: Collection[Actor], gravity: Vector) -> None:
        loose = [one for one in actors if not one.model.plan.is_static and one.size > 0.0]
        heaviest = max(loose, key=lambda one: one.model.mass, default=None)
        self._fixed = {one.model.name for one in actors if one.model.plan.is_static}
        self._length = 1.0 if heaviest is None else heaviest.size
        pull = math.hypot(*gravity) or 9.8
        self._weight = (heaviest.model.mass * pull if heaviest is not None else 0.0) or 1.0

    def felt(self, contact: Contact) -> Iterator[Polyline]:
        """An arrow for the force on the one of two models that can move; on the first if both can."""
        x, y, z = contact.force
        is_other = contact.first.model in self._fixed
        yield from self.arrow(contact.point, (-x, -y, -z) if is_other else (x, y, z))

    def arrow(self, start: Vector, force: Vector) -> Iterator[Polyline]:
        """An arrow for a force [N] that acts at a point of the world [m]."""
        strength = math.hypot(*force)
        length = min(strength / self._weight, _LONGEST) * self._length
        if length < 1e-4 * self._length:
            return
        unit = (force[0] / strength, force[1] / strength, force[2] / strength)
        tip = along(start, unit, length)
        yield (start, tip)
        back = along(start, unit, (1.0 - _BARB) * length)
        for side in _across(unit):
            yield (tip, along(back, side, _BARB_WIDTH * length))


def contact_marks(contacts: Iterable[Contact], scale: ForceScale, *, is_on: bool) -> Marks:
    """Where models touch, with arrows for the forces in the last step.

    Args:
        contacts: Where they touch.
        scale: How long arrows are.
        is_on: Whether they are seen at first.
    """
    found = list(contacts)
    return Marks(
        name=CONTACTS,
        label="Contacts",
        color=_CONTACT_COLOR,
        points=tuple(one.point for one in found),
        lines=tuple(line for one in found for line in scale.felt(one)),
        is_on=is_on,
        shines_through=True,
    )


def laser_marks(points: Iterable[Vector], *, is_on: bool) -> Marks:
    """What lasers see.

    Args:
        points: Where their beams end [m].
        is_on: Whether it is seen at first.
    """
    return Marks(name=SCANS, label="Laser", color=_SCAN_COLOR, points=tuple(points), is_on=is_on)


def scan_points(things: Iterable[Thing]) -> tuple[Vector, ...]:
    """Where the beams of all lasers end in the world [m]; nothing for beams that hit nothing."""
    plugins: list[Any] = [plugin for one in things for plugin in one.plugins]
    return tuple(
        (x, y, z)
        for plugin in plugins
        if hasattr(plugin, "scan_points")
        for x, y, z in plugin.scan_points().points.tolist()
        if math.isfinite(x + y + z)
    )


def _across(unit: Vector) -> tuple[Vector, ...]:
    """Four directions across one of unit length."""
    x, y, z = unit
    across = (-y, x, 0.0) if abs(z) < 0.9 else (0.0, -z, y)
    length = math.hypot(*across)
    a, b, c = (value / length for value in across)
    d, e, f = y * c - z * b, z * a - x * c, x * b - y * a
    return ((a, b, c), (-a, -b, -c), (d, e, f), (-d, -e, -f))


_ROOM: Final = 2.0
"So much room there is around a model that drives, in lengths of it."


@dataclass(frozen=True, slots=True)
class _Bare:
    """A model of which nobody knows the file."""

    model: Model
    robot: None = None
    sdf: None = None
    plugins: tuple[()] = ()


class WorldSource:
    """Looks at a world; the shapes of a model are made once.

    Args:
        things: The world and its models.
        settings: What is to be seen.
        is_live: Whether the view follows the world: then its camera leaves room for models that drive.

    Raises:
        UnknownNameError: There is no model to look at, of that name.
    """

    def __init__(
        self, things: WorldOfThings, settings: WorldSettings, *, is_live: bool = False
    ) -> None:
        self.settings = settings
        self._is_live = is_live
        self._things = things
        self._actors: dict[str, Actor] = {}
        self._version = 0
        self.shapes()
        if settings.look_at and settings.look_at not in self._actors:
            raise UnknownNameError("model", settings.look_at, self._actors)

    def scene(self) -> Scene:
        """What is to be seen now."""
        frames, marks = self.frames().poses, self.marks()
        actors, poses = list(self._actors.values()), {pose.name: pose for pose in frames}
        return world_scene(
            actors,
            frames,
            self.settings,
            outlines={actor.name: list(self._outline(actor, poses)) for actor in actors},
            marks=marks,
            headline=headline(actors, None if self._is_live else self._things.world.time_ns / 1e9),
        )

    def frames(self) -> TfScene:
        """Where the links are now."""
        self.shapes()
        poses: list[FramePose] = []
        for actor in self._actors.values():
            if not actor.is_ground:
                poses += link_poses(actor.model, name=actor.name)
        return TfScene(fixed_frame=WORLD, poses=tuple(poses), error="", problems=())

    def marks(self) -> tuple[Marks, ...]:
        """Contacts, and what lasers see."""
        self.shapes()
        actors, world = list(self._actors.values()), self._things.world
        scale = ForceScale(actors, world.gravity)
        return (
            contact_marks(world.contacts(), scale, is_on=self.settings.contacts),
            laser_marks(scan_points(actor.thing for actor in actors), is_on=self.settings.scans),
        )

    def _outline(self, actor: Actor, poses: Mapping[str, FramePose]) -> Iterator[Vector]:
        room = _ROOM * actor.size if self._is_live and actor.model.is_free else 0.0
        for x, y, z in shape_corners(actor.shapes, poses):
            yield from ((x + dx, y + dy, z) for dx in (-room, room) for dy in (-room, room))

    def shapes(self) -> int:
        """A number that grows when models come or go."""
        things = things_in(self._things)
        actors: dict[str, Actor] = {}
        for thing in things:
            name = thing.model.name
            known = self._actors.get(name)
            is_known = known is not None and known.model is thing.model
            actors[name] = known if is_known and known else make_actor(thing, name=name)
        if list(map(id, actors.values())) != list(map(id, self._actors.values())):
            self._version += 1
        self._actors = actors
        return self._version


def things_in(things: WorldOfThings) -> list[Thing]:
    """All models of a world, the oldest first, also those of which nobody knows the file."""
    spawned = things.spawned
    models = things.world.models
    return [spawned.get(name) or _Bare(model) for name, model in models.items()]


def headline(actors: Sequence[Actor], seconds: float | None) -> str:
    """Which models there are, and when.

    Args:
        actors: The models.
        seconds: Time of the world [s]; None if it goes on.
    """
    names = [abbreviated(actor.name, LONGEST) for actor in actors if not actor.is_ground]
    more = f" and {len(names) - 6} more" if len(names) > 6 else ""
    shown = ", ".join(names[:6]) + more
    when = "" if seconds is None else f", after {seconds:.2f} s"
    return (shown or "An empty world") + when
