"""Which plugins there are, and what their tags may say; the code of one is imported when a model has it.

    @plugin("pump.Pump")
    @dataclass(frozen=True, slots=True, kw_only=True)
    class PumpParameters:
        rate: float = tag("updateRate", 100.0, "Publications per second; 0: each step [Hz].", at_least=0.0)

in `tags` is the entry of `libgazebo_ros_pump.so`, the parser of its tag, and what check_urdf knows of it. Nothing is imported
here but the standard library.
"""

from __future__ import annotations

import dataclasses
import enum
import importlib
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from simkit.plugins.plugin import Plugin

P = TypeVar("P", bound=type[Any])

SILENT = ("robotNamespace", "alwaysOn", "rosDebugLevel")
"""Tags that any plugin may have, whether it reads them or not."""


class Names(enum.Enum):
    """What the text of a tag is the name of."""

    NOTHING = enum.auto()
    """Of nothing in the robot."""
    JOINT = enum.auto()
    """A joint that moves."""
    JOINTS = enum.auto()
    """Joints that move, with commas between them."""
    LINK = enum.auto()
    """A link that must be there."""
    FRAME = enum.auto()
    """A frame of TF, mostly that of a link."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TagField:
    """What a field of a parameter class says of the tag that it comes from."""

    name: str
    """Name of the tag."""
    default: Any
    """What holds if it is not given; of the type that it has: text, float, int or bool."""
    text: str
    """What it means, with the unit in square brackets."""
    required: bool = False
    """Whether the plugin does not work without it."""
    at_least: float = -math.inf
    """Smallest number."""
    above: float = -math.inf
    """All numbers are greater than this."""
    choices: tuple[str, ...] = ()
    """What it may be; anything if empty."""
    names: Names = Names.NOTHING
    """What it names; the default is then a name, too, but for an empty one and `world`."""
    spellings: tuple[str, ...] = ()
    """Words that people write for it, and that the plugin does not read."""


def tag(
    name: str,
    default: Any,
    text: str,
    *,
    required: bool = False,
    at_least: float = -math.inf,
    above: float = -math.inf,
    choices: tuple[str, ...] = (),
    names: Names = Names.NOTHING,
    spellings: tuple[str, ...] = (),
) -> Any:
    """A field of a parameter class: type, default and bounds of one tag; see `TagField`."""
    found = TagField(
        name=name,
        default=default,
        text=text,
        required=required,
        at_least=at_least,
        above=above,
        choices=choices,
        names=names,
        spellings=spellings,
    )
    return dataclasses.field(default=default, metadata={"tag": found})


def tags_of(parameters: type[Any]) -> dict[str, TagField]:
    """The tags that a parameter class reads, by the name of the field."""
    return {one.name: one.metadata["tag"] for one in dataclasses.fields(parameters)}


@dataclass(frozen=True, slots=True, kw_only=True)
class PluginEntry:
    """One plugin."""

    filename: str
    """Its library, as in `<plugin filename="...">`."""
    module: str
    """Python module of its class."""
    class_name: str
    """Its class."""
    parameters: type[Any]
    """What its tag may say."""
    sensor: str | None = None
    """Type of the `<sensor>` that its tag stands in; None for a plugin of the model."""
    ignored: tuple[str, ...] = ()
    """Words that are often written into its tag, and have no effect."""
    silent: tuple[str, ...] = ()
    """Words that are no parameters of the plugin here, and yet are no mistakes."""

    @property
    def tags(self) -> dict[str, TagField]:
        """What its tag may say, by the name of the tag."""
        return {one.name: one for one in tags_of(self.parameters).values()}

    @property
    def spellings(self) -> dict[str, str]:
        """Words that people write, each with the tag that is meant: the names of the fields, as in ROS 2, and others."""
        fields = tags_of(self.parameters).items()
        return {
            word: tag.name
            for field, tag in fields
            for word in (field, *tag.spellings)
            if word not in self.tags
        }

    def load(self) -> type[Plugin[Any]]:
        """Its class."""
        found: type[Plugin[Any]] = getattr(importlib.import_module(self.module), self.class_name)
        return found


_ENTRIES: list[PluginEntry] = []


def plugin(
    home: str,
    *,
    sensor: str | None = None,
    ignored: tuple[str, ...] = (),
    silent: tuple[str, ...] = (),
) -> Callable[[P], P]:
    """Enter a plugin with what its tag may say: a decorator of its parameter class.

    Args:
        home: Module and class in this package, `laser.Laser` for `libgazebo_ros_laser.so`.
        sensor: Type of the `<sensor>` that its tag stands in.
        ignored: Words that are often written into its tag, and have no effect.
        silent: Words that are no parameters, and yet are no mistakes.
    """
    module, _, class_name = home.rpartition(".")

    def enter(parameters: P) -> P:
        entry = PluginEntry(
            filename=f"libgazebo_ros_{home.partition('.')[0]}.so",
            module=f"{__package__}.{module}",
            class_name=class_name,
            parameters=parameters,
            sensor=sensor,
            ignored=ignored,
            silent=silent,
        )
        _ENTRIES.append(entry)
        return parameters

    return enter


def plugins() -> dict[str, PluginEntry]:
    """All plugins by filename."""
    importlib.import_module(f"{__package__}.tags")  # whose classes enter them
    return {entry.filename: entry for entry in _ENTRIES}


_NOT_HERE = (
    "ackermann_drive", "block_laser", "camera", "depth_camera", "elevator", "f3d", "force",
    "ft_sensor", "gps_sensor", "gpu_laser", "hand_of_god", "harness", "joint_pose_trajectory",
    "magnetometer_sensor", "multicamera", "openni_kinect", "planar_move", "projector",
    "prosilica", "range", "ray_sensor", "template", "tricycle_drive", "triggered_camera",
    "vacuum_gripper", "video", "wheel_slip", "wheel_odometry", "api_plugin", "paths_plugin",
)  # fmt: skip
NOT_HERE = frozenset(f"libgazebo_ros_{name}.so" for name in _NOT_HERE)
"""Plugins of gazebo_ros that simkit does not have."""
