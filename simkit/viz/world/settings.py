"""What a person sets in the window of Gazebo, in its menu View."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.viz.scene import Displays
from simkit.viz.solid import Role


@dataclass(frozen=True, slots=True, kw_only=True)
class WorldSettings:
    """Which displays are on at first; a person may turn them on and off in the view."""

    models: bool = True
    """What is seen of the models."""
    collisions: bool = False
    """What others touch of them."""
    contacts: bool = False
    """Where models touch each other, and how hard."""
    center_of_mass: bool = False
    """The centre of mass of each link."""
    inertias: bool = False
    """A box of equal inertia for each link."""
    joints: bool = False
    """The axes of joints."""
    link_frames: bool = False
    """Axes and names of the links."""
    scans: bool = True
    """What lasers see."""
    grid: bool = True
    """The grid on the ground."""
    transparent: bool | None = None
    """Whether one sees through the models; if None, when something inside of them is shown."""
    look_at: str = ""
    """Model that the camera looks at; all of them if empty."""

    @property
    def displays(self) -> Displays:
        """What is seen at first."""
        roles = {
            Role.COLLISION: self.collisions,
            Role.CENTRE: self.center_of_mass,
            Role.INERTIA: self.inertias,
            Role.JOINT: self.joints,
            Role.GROUND: True,
        }
        is_inner = self.center_of_mass or self.inertias or self.joints
        return Displays(
            grid=self.grid,
            tf=self.link_frames,
            robot=Role.VISUAL if self.models else None,
            also=tuple(role for role, is_on in roles.items() if is_on),
            transparent=is_inner if self.transparent is None else self.transparent,
        )
