"""Robots that move though nobody tells them to."""

from __future__ import annotations

import math

from simkit.gazebo.watching.motion import LOOK_S, turned
from simkit.gazebo.watching.watcher import DriveWatcher, Finding, Scene

LOOKS, SETTLING = 60, 10
"""It stands for so many looks, of which the first ones are for coming to rest; the rest are 5 s."""
FAR, ROUND = 0.01, 0.02
"""How far it may creep [m], and how far it may turn [rad], in that time."""


class Drifting(DriveWatcher):
    """Looks at a robot on wheels that is told to stand."""

    rule = "GZ-W05"

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._looks = 0

    def look(self) -> Finding | None:
        """Whether it creeps; asked once in 6 s of standing."""
        self._looks = 0 if any(self.drive.command()) else self._looks + 1
        if self._looks % LOOKS or not self._looks:
            return None
        moments = self.motion.last(LOOKS)
        if not moments or any(any(one.command) for one in moments):
            return None
        first, last = moments[SETTLING], moments[-1]
        way = math.dist(first.place[:2], last.place[:2])
        turn = abs(turned(first.yaw, last.yaw))
        if way < FAR and turn < ROUND:
            return None
        return Finding(
            text=f"{self.model.name} moves though nothing is commanded: {way:.2g} m and {math.degrees(turn):.2g} degrees "
            f"in {(LOOKS - SETTLING) * LOOK_S:g} s. Check the friction of its wheels (<mu1>1</mu1>), that all wheels "
            "and casters stand at one height, and that its inertias fit its shapes"
        )
