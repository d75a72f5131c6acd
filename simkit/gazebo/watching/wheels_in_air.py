"""Wheels that turn in the air: the robot stands on something else."""

from __future__ import annotations

from simkit.gazebo.watching.floor import floor_height, foot
from simkit.gazebo.watching.load import touching
from simkit.gazebo.watching.watcher import DriveWatcher, Finding, Scene

PATIENCE = 5
"""So many looks in a row the wheels touch nothing."""
ENOUGH = 20
"""After so many looks at wheels that all touch something, they will do so."""
CALM = 0.05
"""What is slower up and down [m/s] does not fall."""


class WheelsInAir(DriveWatcher):
    """Looks at wheels that are told to turn."""

    rule = "GZ-W04"

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._looks = 0
        self._good_looks = 0

    def look(self) -> Finding | None:
        """Whether wheels of a robot that stands touch nothing."""
        is_told = any(joint.command for joint in self.drive.joints)
        if not is_told or abs(self.model.twist[0][2]) > CALM:
            self._looks = 0
            return None
        down = touching(self.scene)
        hanging = [joint for joint in self.drive.joints if joint.plan.child not in down]
        self._looks = self._looks + 1 if hanging and down else 0
        self._good_looks = 0 if hanging else self._good_looks + 1
        self.is_over = self._good_looks >= ENOUGH
        if self._looks < PATIENCE:
            return None
        links = ", ".join(repr(joint.plan.child) for joint in hanging)
        return Finding(
            text=f"{self.model.name} is told to drive, and {links} {'touches' if len(hanging) == 1 else 'touch'} "
            f"nothing{self._gap(hanging[0].plan.child)}: it stands on {', '.join(map(repr, sorted(down)))}. Move the "
            "wheels down, or what it stands on up"
        )

    def _gap(self, body: str) -> str:
        lowest, floor = foot(self.model, body=body), floor_height(self.scene.gazebo.world)
        if lowest is None:
            return ", as it has no <collision>"
        return "" if floor is None else f", {max(0.0, lowest.z - floor):.2g} m above the floor"
