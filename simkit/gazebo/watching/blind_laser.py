"""Lasers that see their own robot."""

from __future__ import annotations

from simkit.gazebo.watching.watcher import Finding, Scene, Watcher
from simkit.plugins.laser import Laser

MANY = 0.05
"""From this share of the beams on it is worth a warning; less may be a mast."""
SETTLED = 5
"""After so many looks it is looked through the laser, once."""


class BlindLaser(Watcher):
    """Looks through each laser once."""

    rule = "LAS-W01"
    is_said_by_rule = True

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._looks = 0

    @classmethod
    def is_for(cls, scene: Scene) -> bool:
        """Whether it has a laser."""
        return any(isinstance(plugin, Laser) for plugin in scene.spawned.plugins)

    def look(self) -> Finding | None:
        """What the lasers see of the robot."""
        self._looks += 1
        if self._looks < SETTLED:
            return None
        self.is_over = True
        lasers = [plugin for plugin in self.scene.spawned.plugins if isinstance(plugin, Laser)]
        texts = [text for laser in lasers if (text := self._seen(laser)) is not None]
        return Finding(text="; ".join(texts)) if texts else None

    def _seen(self, laser: Laser) -> str | None:
        """What is wrong with what a laser sees."""
        sight = laser.scan_points()
        owners = self.scene.gazebo.world.targets
        count = len(sight.ranges)
        own = [
            (float(reach), owners[target].plan.link)
            for reach, target in zip(sight.ranges, sight.targets, strict=True)
            if target >= 0 and owners[target].model == self.model.name
        ]
        if len(own) >= max(1.0, MANY * count):
            nearest, link = min(own)
            return (
                f"the laser {laser.name!r} of {self.model.name} sees the robot itself with {len(own)} of {count} beams: "
                f"{link!r} is {max(nearest, laser.ray.near):.2g} m away. Lift its link out of that shape, give the link no "
                "<collision>, or raise <min> beyond it"
            )
        return None
