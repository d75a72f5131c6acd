"""What a person sets in RViz: the fixed frame, and which displays there are.

Source: RViz 1.14 for names, colours and usual settings of the displays of topics.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar, Final, TypeAlias

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Time
from simkit.tf import LATEST
from simkit.viz.stage.parts import Color, Role
from simkit.viz.stage.scene import Displays

ODOMETRY_COLOR: Final[Color] = (1.0, 25 / 255, 0.0)
"""Of the arrows of odometry."""
ARROW_LENGTH: Final = 0.3
"""Of an arrow, unless a person says otherwise [m]; RViz' own is 1.3 m long, too long for the robots of the lecture."""
PATH_COLOR: Final[Color] = (25 / 255, 1.0, 0.0)
"""Of a path."""
KEEP: Final = 100
"""So many arrows of odometry are kept."""
MOST_KEPT: Final = 10_000
"""No more arrows can be kept."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LaserScanDisplay:
    """Points where the beams of a laser met something."""

    kind: ClassVar[str] = "LaserScan"
    type_name: ClassVar[str] = "sensor_msgs/LaserScan"

    topic: str
    """Resolved name of its topic."""
    color: Color | None = None
    """One colour for all points; if None, from red for the nearest to violet for the farthest range."""


@dataclass(frozen=True, slots=True, kw_only=True)
class OdometryDisplay:
    """A trail of arrows: where a robot said that it was.

    Raises:
        SimkitError: `keep` is out of range, or a tolerance is negative.
    """

    kind: ClassVar[str] = "Odometry"
    type_name: ClassVar[str] = "nav_msgs/Odometry"

    topic: str
    """Resolved name of its topic."""
    color: Color = ODOMETRY_COLOR
    """Colour of the arrows."""
    keep: int = KEEP
    """So many arrows are shown, the newest ones."""
    position_tolerance: float = 0.1
    """No new arrow nearer than this to the last [m], unless it has turned."""
    angle_tolerance: float = 0.1
    """No new arrow that is turned by less than this [rad], unless it has moved."""
    length: float = ARROW_LENGTH
    """From the end to the tip of an arrow [m]."""

    def __post_init__(self) -> None:
        if isinstance(self.keep, bool) or not 1 <= self.keep <= MOST_KEPT:
            raise SimkitError(f"keep is a number of arrows from 1 to {MOST_KEPT}, not {self.keep}")
        for size in (self.position_tolerance, self.angle_tolerance, self.length):
            if not 0.0 <= size < math.inf:
                raise SimkitError(f"a tolerance or length of an odometry display is not {size}")


@dataclass(frozen=True, slots=True, kw_only=True)
class PathDisplay:
    """A line through the poses of a path."""

    kind: ClassVar[str] = "Path"
    type_name: ClassVar[str] = "nav_msgs/Path"

    topic: str
    """Resolved name of its topic."""
    color: Color = PATH_COLOR
    """Colour of the line."""


TopicDisplay: TypeAlias = LaserScanDisplay | OdometryDisplay | PathDisplay
"""A display that shows a topic."""

SHOWN_TYPES: Final = tuple(
    sorted(one.type_name for one in (LaserScanDisplay, OdometryDisplay, PathDisplay))
)
"""Types of messages that have a display."""


def display_of(topic: str, type_name: str, *, keep: int = KEEP) -> TopicDisplay:
    """The display that a person gets who adds one "by topic".

    Args:
        topic: Resolved name of the topic.
        type_name: Type of its messages, e.g. `nav_msgs/Path`.
        keep: So many arrows of odometry are kept.

    Raises:
        SimkitError: No display shows messages of this type.
    """
    match type_name:
        case LaserScanDisplay.type_name:
            return LaserScanDisplay(topic=topic)
        case OdometryDisplay.type_name:
            return OdometryDisplay(topic=topic, keep=keep)
        case PathDisplay.type_name:
            return PathDisplay(topic=topic)
        case _:
            raise SimkitError(
                f"no display shows topic {topic}, a {type_name}; there are displays of "
                + ", ".join(SHOWN_TYPES)
            )


def displays_of(types: Mapping[str, str], *, keep: int = KEEP) -> tuple[TopicDisplay, ...]:
    """A display for each topic that has one.

    Args:
        types: Type of the messages of each topic, by resolved name.
        keep: So many arrows of odometry are kept.
    """
    return tuple(
        display_of(topic, type_name, keep=keep)
        for topic, type_name in types.items()
        if type_name in SHOWN_TYPES
    )


def label(display: TopicDisplay) -> str:
    """Its name for people, e.g. `LaserScan /scan`."""
    return f"{display.kind} {display.topic}"


DESCRIPTION: Final = "/robot_description"
"""Parameter that holds the URDF of a robot."""
_ROLES = {role.value: role for role in (Role.VISUAL, Role.COLLISION)}


@dataclass(frozen=True, slots=True)
class RobotDisplay:
    """A display RobotModel: which robot it shows."""

    description: str = DESCRIPTION
    """Parameter with its URDF."""
    tf_prefix: str = ""
    """Its "TF Prefix": what stands before the names of its links in tf; empty if nothing does."""


def robot_displays(
    description: str | Iterable[str] | Mapping[str, str],
) -> tuple[RobotDisplay, ...]:
    """The displays that a person asks for.

    Args:
        description: A parameter, several, or with the TF Prefix of each; `left` and `/left/` are the same.
    """
    names = [description] if isinstance(description, str) else description
    table = names if isinstance(names, Mapping) else dict.fromkeys(names, "")
    return tuple(RobotDisplay(name, prefix.strip("/")) for name, prefix in table.items())


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
