"""Models that begin in the floor, or far above it."""

from __future__ import annotations

import math

from simkit.gazebo.watching.floor import Foot, floor_height, foot, is_inside
from simkit.gazebo.watching.watcher import Finding, Scene, Watcher

DEEP, HIGH = 0.002, 0.1
"""So deep in the floor, or so high above it [m], is worth a word."""


class StartHeight(Watcher):
    """Looks once, before anything moves."""

    rule = "GZ-W06"

    @classmethod
    def is_for(cls, scene: Scene) -> bool:
        """Whether it can fall, or be pushed."""
        return scene.model.is_free

    def look(self) -> Finding | None:
        """Where the lowest point is."""
        self.is_over = True
        floor, lowest = floor_height(self.scene.gazebo.world), foot(self.model)
        if floor is None or lowest is None:
            return None
        if lowest.z < floor - DEEP:
            return Finding(text=self._in_the_floor(floor - lowest.z, lowest))
        drop = self._drop(lowest)
        if drop is None or drop <= HIGH:
            return None
        return Finding(
            text=f"{self.model.name} starts {drop:.3g} m above what is below it, and falls; "
            f"with -z {self._height(-drop):.2f} it starts on it",
            is_hint=True,
        )

    def _in_the_floor(self, depth: float, lowest: Foot) -> str:
        return (
            f"{self.model.name} starts {depth:.3g} m in the floor: its link {lowest.link!r} reaches down to "
            f"z = {lowest.z:.3g} m. It is pushed out, and in Gazebo it may jump or tip over. "
            f"Spawn it with -z {self._height(depth):.2f}"
        )

    def _height(self, up: float) -> float:
        """Where to spawn it so that it begins higher [m]: in centimetres, rounded up unless it is 1 mm."""
        return math.ceil((self.model.start.translation[2] + up) * 100.0 - 0.1) / 100.0 + 0.0

    def _drop(self, lowest: Foot) -> float | None:
        """How far it is from its lowest point to the next thing below [m]; None if there is nothing."""
        world = self.scene.gazebo.world
        if world.gravity[2] >= 0.0:
            return None
        point = (lowest.x, lowest.y, lowest.z - DEEP)
        others = [one for one in world.models.values() if one is not self.model]
        if any(is_inside(one, point) for one in others):  # it stands on something
            return None
        (distance,) = world.cast_rays(point, [(0.0, 0.0, -1.0)]).distances
        return float(distance) + DEEP if math.isfinite(distance) else None
