"""What a person sets in RViz: the fixed frame, and which displays there are."""

from __future__ import annotations

from dataclasses import dataclass

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Time
from simkit.tf import LATEST
from simkit.viz.robot_description import RobotDisplay
from simkit.viz.scene import Displays
from simkit.viz.solid import Role
from simkit.viz.topics.displays import TopicDisplay

_ROLES = {role.value: role for role in (Role.VISUAL, Role.COLLISION)}


@dataclass(frozen=True, slots=True, kw_only=True)
class RvizSettings:
    """Global options and displays.

    Raises:
        UnknownNameError: `robot_model` is neither "visual" nor "collision" nor None.
        SimkitError: `alpha` is not between 0 and 1.
    """

    fixed_frame: str = "world"
    """The frame that all others are seen from; if empty, one that is there."""
    time: Time = LATEST
    """Moment to show; for each frame its latest time if `Time(0)`."""
    robot_model: str | None = "visual"
    """Which shapes of the robot are seen at first, "visual" or "collision"; None for no robot."""
    alpha: float = 1.0
    """Opacity of the robot, from 0 to 1."""
    show_tf: bool = True
    """Whether axes, names and parents of the frames are seen at first."""
    show_grid: bool = True
    """Whether the grid is seen at first."""
    robots: tuple[RobotDisplay, ...] = (RobotDisplay(),)
    """The robots."""
    topics: tuple[TopicDisplay, ...] = ()
    """The displays of topics."""
    complaint: str = ""
    """A sentence on what is wrong with the settings themselves; empty if nothing is."""

    def __post_init__(self) -> None:
        if self.robot_model is not None and self.robot_model not in _ROLES:
            raise UnknownNameError("robot model", str(self.robot_model), [*_ROLES, "None"])
        if not 0.0 <= self.alpha <= 1.0:
            raise SimkitError(f"alpha is an opacity from 0 to 1, not {self.alpha}")

    @property
    def displays(self) -> Displays:
        """What is seen at first."""
        role = None if self.robot_model is None else _ROLES[self.robot_model]
        return Displays(grid=self.show_grid, tf=self.show_tf, robot=role)
