"""A recording of a world: where every link and joint was, what touched, what lasers saw, over virtual time."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from simkit.errors import SimkitError, UnknownNameError
from simkit.geometry import Vector
from simkit.graph import Node
from simkit.msgs import Duration
from simkit.physics import Contact, Model
from simkit.viz.draw.thinning import Row
from simkit.viz.stage.world_models import WorldOfThings, link_frame
from simkit.viz.stage.world_scene import Actor, link_poses, make_actor
from simkit.viz.stage.world_source import scan_points, things_in
from simkit.viz.tape import pose_row

FASTEST: Final = 1000.0
"""A world is looked at no oftener than it makes steps of 1 ms [Hz]."""
_MS: Final = 1_000_000
_SCAN_PAUSE_NS: Final = 100 * _MS
"What lasers see is kept ten times a second: there are many points in it."


@dataclass(slots=True, kw_only=True)
class ModelTrack:
    """What a model did while it was there."""

    actor: Actor
    """The model."""
    links: dict[str, list[Row]] = field(default_factory=dict)
    """By `model::link`: time [s], x, y, z [m] in the world, quaternion xyzw."""
    joints: dict[str, list[Row]] = field(default_factory=dict)
    """By joint: time [s], position [rad or m], velocity [rad/s or m/s]."""
    until: float | None = None
    """When it was gone [s]; None if it was there to the end."""


class WorldTape:
    """Looks at a world at fixed times, from its creation on; the world does not notice.

    Args:
        things: The world and its models.
        node: A node on its clock.
        rate: How often it looks [Hz], rounded so that whole milliseconds lie in between.

    Attributes:
        start_ns: Virtual time of the beginning [ns].
        gravity: Acceleration of all that falls [m/s^2].

    Raises:
        SimkitError: The rate is not between 0 and 1000 Hz.
    """

    def __init__(self, things: WorldOfThings, node: Node, *, rate: float = 30.0) -> None:
        if not 0.0 < rate <= FASTEST:
            raise SimkitError(f"a world is looked at 0 to {FASTEST:g} times a second, not {rate:g}")
        self._things = things
        self._executor = node.graph.executor
        self.gravity: Vector = things.world.gravity
        self.start_ns = self._executor.now_ns
        self._tracks: list[ModelTrack] = []
        self._contacts: list[tuple[float, tuple[Contact, ...]]] = []
        self._scans: list[tuple[float, tuple[Vector, ...]]] = []
        self._looked_ns = -1
        self._look()
        period = Duration.from_nsec(max(1, round(1000.0 / rate)) * _MS)
        self._timer = node.create_timer(period, self._look)

    def stop(self) -> None:
        """Look once more, and then never again; what was seen stays."""
        self.look()
        self._timer.cancel()

    def look(self) -> None:
        """Keep what is there now; harmless if that is kept already, or if it has been stopped."""
        if not self._timer.cancelled:
            self._look()

    @property
    def duration(self) -> float:
        """From the first to the last look [s]."""
        return (self._looked_ns - self.start_ns) / 1e9

    @property
    def tracks(self) -> tuple[ModelTrack, ...]:
        """What each model did that ever was there, the oldest first."""
        return tuple(self._tracks)

    @property
    def contacts(self) -> list[tuple[float, tuple[Contact, ...]]]:
        """What touched, with the time of the look [s]."""
        return list(self._contacts)

    @property
    def scans(self) -> list[tuple[float, tuple[Vector, ...]]]:
        """Where the beams of lasers ended in the world [m], with the time of the look [s]."""
        return list(self._scans)

    def link(self, model: str, link: str) -> list[Row]:
        """Where a link was.

        Args:
            model: The model; of several of that name the last one.
            link: The link.

        Returns:
            Rows of time [s] since the beginning, x, y, z [m] in the world, quaternion xyzw.

        Raises:
            UnknownNameError: There was no such model, or it has no such link.
        """
        links = self._track(model).links
        name = link_frame(self._track(model).actor.name, link)
        if name not in links:
            known = [one.partition("::")[2] for one in links]
            raise UnknownNameError(f"link in {model!r}", link, known)
        return list(links[name])

    def joint(self, model: str, joint: str) -> list[Row]:
        """Where a joint stood.

        Args:
            model: The model; of several of that name the last one.
            joint: The joint.

        Returns:
            Rows of time [s] since the beginning, position [rad or m], velocity [rad/s or m/s].

        Raises:
            UnknownNameError: There was no such model, or it has no such joint that moves.
        """
        joints = self._track(model).joints
        if joint not in joints:
            raise UnknownNameError(f"moving joint in {model!r}", joint, joints)
        return list(joints[joint])

    def __repr__(self) -> str:
        names = ", ".join(one.actor.name for one in self._tracks if not one.actor.is_ground)
        return f"WorldTape({self.duration:.2f} s of {names or 'an empty world'})"

    def _track(self, model: str) -> ModelTrack:
        found = [one for one in self._tracks if one.actor.model.name == model]
        if not found:
            raise UnknownNameError("recorded model", model, [t.actor.name for t in self._tracks])
        return found[-1]

    def _look(self) -> None:
        now_ns = self._executor.now_ns
        if now_ns == self._looked_ns:
            return
        self._looked_ns = now_ns
        time = self.duration
        self._meet(time)
        for track in self._tracks:
            if track.until is None:
                _keep(track, time)
        contacts = self._things.world.contacts()
        if contacts or (self._contacts and self._contacts[-1][1]):
            self._contacts.append((time, contacts))
        if not self._scans or time - self._scans[-1][0] >= _SCAN_PAUSE_NS / 1e9 - 1e-9:
            points = scan_points(things_in(self._things))
            if points or self._scans:
                self._scans.append((time, points))

    def _meet(self, time: float) -> None:
        """See who came and who went."""
        models = self._things.world.models
        for track in self._tracks:
            if track.until is None and models.get(track.actor.model.name) is not track.actor.model:
                track.until = time
        here = {id(track.actor.model) for track in self._tracks}
        for thing in things_in(self._things):
            if id(thing.model) not in here:
                name = self._free_name(thing.model)
                self._tracks.append(ModelTrack(actor=make_actor(thing, name=name)))

    def _free_name(self, model: Model) -> str:
        """The name of a model; with a number behind it if there was another one of that name before."""
        number = 1 + sum(track.actor.model.name == model.name for track in self._tracks)
        return model.name if number == 1 else f"{model.name} ({number})"


def _keep(track: ModelTrack, time: float) -> None:
    actor = track.actor
    if actor.is_ground:
        return
    for pose in link_poses(actor.model, name=actor.name):
        rows = track.links.setdefault(pose.name, [])
        rows.append(pose_row(rows, time, pose.origin, pose.rotation))
    for joint in actor.model.joints.values():
        row = (time, joint.position, joint.velocity)
        track.joints.setdefault(joint.name, []).append(row)
