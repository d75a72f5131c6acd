"""Which plugins there are; the code of one is imported when a model has it."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from simkit.plugins import tags

if TYPE_CHECKING:
    from simkit.plugins.plugin import Plugin


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

    def load(self) -> type[Plugin[Any]]:
        """Its class."""
        found: type[Plugin[Any]] = getattr(importlib.import_module(self.module), self.class_name)
        return found


_ENTRIES: tuple[PluginEntry, ...] = (
    PluginEntry(
        filename="libgazebo_ros_diff_drive.so",
        module="simkit.plugins.diff_drive",
        class_name="DiffDrive",
        parameters=tags.DiffDriveParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_skid_steer_drive.so",
        module="simkit.plugins.skid_steer_drive",
        class_name="SkidSteerDrive",
        parameters=tags.SkidSteerDriveParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_joint_state_publisher.so",
        module="simkit.plugins.joint_state_publisher",
        class_name="GazeboJointStatePublisher",
        parameters=tags.JointStatePublisherParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_p3d.so",
        module="simkit.plugins.p3d",
        class_name="P3d",
        parameters=tags.P3dParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_control.so",
        module="simkit.plugins.control.plugin",
        class_name="GazeboRosControl",
        parameters=tags.ControlParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_laser.so",
        module="simkit.plugins.laser",
        class_name="Laser",
        parameters=tags.LaserParameters,
        sensor="ray",
    ),
    PluginEntry(
        filename="libgazebo_ros_imu.so",
        module="simkit.plugins.imu",
        class_name="Imu",
        parameters=tags.ImuParameters,
    ),
    PluginEntry(
        filename="libgazebo_ros_imu_sensor.so",
        module="simkit.plugins.imu_sensor",
        class_name="ImuSensor",
        parameters=tags.ImuSensorParameters,
        sensor="imu",
    ),
    PluginEntry(
        filename="libgazebo_ros_bumper.so",
        module="simkit.plugins.bumper",
        class_name="Bumper",
        parameters=tags.BumperParameters,
        sensor="contact",
    ),
)


def plugins() -> dict[str, PluginEntry]:
    """All plugins by filename."""
    return {entry.filename: entry for entry in _ENTRIES}
