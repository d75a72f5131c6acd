"""Where the scenes of a world come from: what physics says at this moment."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from simkit.errors import UnknownNameError
from simkit.geometry import Vector
from simkit.physics import Model
from simkit.viz.draw.letters import shortened
from simkit.viz.marks import Marks
from simkit.viz.scene import LONGEST, Scene
from simkit.viz.tf_scene import FramePose, TfScene
from simkit.viz.world.marks import ForceScale, contact_marks, laser_marks, scan_points
from simkit.viz.world.scene import WORLD, Actor, link_poses, make_actor, outline, world_scene
from simkit.viz.world.settings import WorldSettings
from simkit.viz.world.things import Thing, WorldOfThings

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
        for x, y, z in outline(actor.shapes, poses):
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
    names = [shortened(actor.name, LONGEST) for actor in actors if not actor.is_ground]
    more = f" and {len(names) - 6} more" if len(names) > 6 else ""
    shown = ", ".join(names[:6]) + more
    when = "" if seconds is None else f", after {seconds:.2f} s"
    return (shown or "An empty world") + when
