"""Which watchers there are; lets them look, and says what they find."""

from __future__ import annotations

from simkit.diagnostics import Severity
from simkit.gazebo.models import Spawned
from simkit.gazebo.server import Gazebo
from simkit.gazebo.watchers import drive_watchers, robot_watchers
from simkit.gazebo.watchers.motion import LOOK_S
from simkit.gazebo.watchers.scene import Hint, Looks, WatchedModel, Watcher
from simkit.graph.node import Timer
from simkit.msgs import Duration
from simkit.urdf.rules import check_robot

WATCHERS: tuple[Watcher, ...] = (
    robot_watchers.start_height,
    drive_watchers.wheels_in_air,
    drive_watchers.wrong_way,
    drive_watchers.wrong_size,
    robot_watchers.weak_joints,
    drive_watchers.slipping,
    drive_watchers.drifting,
    robot_watchers.two_publishers,
    robot_watchers.no_states,
    robot_watchers.blind_laser,
)
"""In the order in which they speak."""


class Watch:
    """Watches the models of a world; while there is nothing to watch it does nothing at all.

    Args:
        gazebo: The world.
    """

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo = gazebo
        self._watchers: dict[str, list[tuple[Watcher, Looks]]] = {}
        self._scenes: dict[str, WatchedModel] = {}
        self._warned: dict[str, frozenset[str]] = {}
        self._timer: Timer | None = None
        self._looked_ns = gazebo.world.time_ns
        for spawned in gazebo.spawned.values():
            self.watch_spawn(spawned)
        gazebo.on_spawn.append(self.watch_spawn)
        gazebo.on_delete.append(self.forget)

    def watch_spawn(self, spawned: Spawned) -> None:
        """Watch a model that has come into the world."""
        self.forget(spawned)
        if spawned.model.plan.is_static:
            return
        scene = WatchedModel(self._gazebo, spawned)
        watchers = [(one, one.looks(scene)) for one in WATCHERS]
        self._watchers[spawned.name] = self._still_watching(scene, watchers)
        self._scenes[spawned.name] = scene
        if self._timer is None:
            self._timer = self._gazebo.node.create_timer(Duration.from_sec(LOOK_S), self._look)

    def forget(self, spawned: Spawned) -> None:
        """Watch a model no more."""
        self._watchers.pop(spawned.name, None)
        self._scenes.pop(spawned.name, None)
        self._warned.pop(spawned.name, None)

    def _look(self) -> None:
        time_ns = self._gazebo.world.time_ns
        if time_ns == self._looked_ns:  # it stands still
            return
        self._looked_ns = time_ns
        for name, watchers in list(self._watchers.items()):
            self._watchers[name] = self._still_watching(self._scenes[name], watchers)
        if not any(self._watchers.values()) and self._timer is not None:
            self._timer.cancel()
            self._timer = None

    def _still_watching(
        self, scene: WatchedModel, watchers: list[tuple[Watcher, Looks]]
    ) -> list[tuple[Watcher, Looks]]:
        """Let watchers look; those that have more to look at."""
        if watchers and scene.motion is not None:
            scene.motion.look()
        left = []
        for watcher, looks in watchers:
            found = next(looks, "")
            if found is None:
                left.append((watcher, looks))
            elif found:
                self._say(scene, watcher, found)
        return left

    def _say(self, scene: WatchedModel, watcher: Watcher, found: str) -> None:
        if watcher.is_said_by_rule and watcher.rule in self._warnings(scene.spawned):
            return
        say = self._gazebo.node.info if isinstance(found, Hint) else self._gazebo.node.warn
        say(f"[{watcher.rule}] {found}")

    def _warnings(self, spawned: Spawned) -> frozenset[str]:
        """The rules under which `check_urdf` warned when a robot was spawned."""
        if spawned.name not in self._warned:
            document = None if spawned.robot is None else spawned.robot.document
            found = (
                () if document is None else check_robot(document, packages=self._gazebo.packages)
            )
            self._warned[spawned.name] = frozenset(
                one.rule for one in found if one.severity is not Severity.NOTE
            )
        return self._warned[spawned.name]


def watch(gazebo: Gazebo) -> Watch:
    """Watch the models of a world, those that are there and those that come."""
    return Watch(gazebo)
