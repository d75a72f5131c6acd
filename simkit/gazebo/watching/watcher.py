"""What a watcher is: it looks at one model now and then, and speaks at most once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from simkit.gazebo.models import Spawned
from simkit.gazebo.server import Gazebo
from simkit.gazebo.watching.motion import DrivenWheels, Motion, drive_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Observation:
    """Something that is wrong, or worth knowing."""

    text: str
    """What, with numbers, and what would be right."""
    is_hint: bool = False
    """Whether it may well be meant so."""


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
        self.drive = drive_of(spawned)
        """Its driven wheels; None if it has none."""
        self.motion = None if self.drive is None else Motion(self.drive)
        """What it did in the last looks, if it has wheels."""


class Watcher:
    """Watches one model for one kind of fault.

    Args:
        scene: What it looks at.
    """

    rule: ClassVar[str] = ""
    """Id of the fault, as `check_urdf` has it."""
    is_said_by_rule: ClassVar[bool] = False
    """Whether it says what `check_urdf` says under this id; then it is silent if that has warned."""

    def __init__(self, scene: WatchedModel) -> None:
        self.scene = scene
        self.model = scene.model
        self.is_over = False
        """Whether there is nothing to look at any more."""

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether such a fault can happen to a model."""
        raise NotImplementedError

    def look(self) -> Observation | None:
        """What is wrong, if it is; called right after spawning, and then every 0.1 s that the world moves."""
        raise NotImplementedError


class DriveWatcher(Watcher):
    """Watches a model that drives on wheels."""

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        if scene.drive is None or scene.motion is None:
            raise ValueError(f"{scene.model.name} has no wheels to watch")
        self.drive: DrivenWheels = scene.drive
        self.motion: Motion = scene.motion

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether it has wheels, and can go anywhere."""
        return scene.drive is not None and scene.model.is_free
