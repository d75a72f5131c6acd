"""The plugin `libgazebo_ros_skid_steer_drive.so`: four wheels with motors, two on a side.

Source: gazebo_ros_skid_steer_drive of ROS Melodic and Noetic.
"""

from __future__ import annotations

import dataclasses
from typing import ClassVar

from simkit.plugins.odometry import (
    Covariances,
    Frames,
    OdometryPublisher,
    planar_covariance,
    world_motion,
)
from simkit.plugins.parameters import resolve_frame, shown_namespace, tf_prefix, topic_of
from simkit.plugins.plugin import Plugin
from simkit.plugins.rate import UpdateRate
from simkit.plugins.site import Site
from simkit.plugins.tags import SkidSteerDriveParameters
from simkit.plugins.wheels import MotorWheel, TwistListener


class SkidSteerDrive(Plugin[SkidSteerDriveParameters]):
    """Drives a robot as `cmd_vel` says, and reports where it is in truth.

    To turn, the wheels of one side slip: how fast it turns depends on friction, and is not what is
    commanded. Names of a tag without `robotNamespace` are at the root, also in a world file. Where the
    original obeys the last command again after a reset, this one waits for the next.

    Args:
        site: Where it works.
        parameters: What its tag says.

    Raises:
        PluginError: The model has no such joints, or there can be no such topics.
    """

    Parameters: ClassVar[type[SkidSteerDriveParameters]] = SkidSteerDriveParameters

    def __init__(self, site: Site, parameters: SkidSteerDriveParameters) -> None:
        super().__init__(_at_root(site), parameters)
        given = parameters
        self._command_topic = topic_of(self.site, "commandTopic", given.command_topic)
        self._odometry_topic = topic_of(self.site, "odometryTopic", given.odometry_topic)
        self._left = [
            self._wheel("leftFrontJoint", given.left_front_joint),
            self._wheel("leftRearJoint", given.left_rear_joint),
        ]
        self._right = [
            self._wheel("rightFrontJoint", given.right_front_joint),
            self._wheel("rightRearJoint", given.right_rear_joint),
        ]

    @classmethod
    def speaker(cls, site: Site) -> str:
        """Name and namespace, as the original writes them."""
        return f"GazeboRosSkidSteerDrive Plugin (ns = {shown_namespace(_at_root(site))})"

    def on_attach(self) -> None:
        """Advertise, listen, and hold the wheels."""
        site, given = self.site, self.parameters
        site.node.info(f"Starting {self.speaker(site)}")
        prefix = tf_prefix(site)
        covariance = planar_covariance(given.covariance_x, given.covariance_y, given.covariance_yaw)
        self._commands = TwistListener(site, self._command_topic)
        self._odometry = OdometryPublisher(
            site,
            self._odometry_topic,
            frames=Frames(
                parent=resolve_frame(given.odometry_frame, prefix),
                child=resolve_frame(given.robot_base_frame, prefix),
            ),
            covariances=Covariances(pose=covariance, twist=covariance),
            on_tf=given.broadcast_tf,
        )
        self._begin()

    @property
    def due_ns(self) -> int:
        """Each period."""
        return self._rate.due_ns

    def after_step(self) -> None:
        """If it is time, report and obey."""
        if self._rate.is_due(self.site.now_ns):
            self._odometry.publish(world_motion(self.site.model), has_height=False)
            self._drive(*self._commands.rim_speeds(self.parameters.wheel_separation))

    def on_reset(self) -> None:
        """Forget the command."""
        self._commands.forget()
        self._begin()

    def on_detach(self) -> None:
        """Withdraw from all topics, and let the wheels roll."""
        self._odometry.close()
        self._commands.close()
        for wheel in (*self._left, *self._right):
            wheel.release()

    # -- private

    def _wheel(self, name: str, joint: str) -> MotorWheel:
        given = self.parameters
        return MotorWheel(
            self.site,
            name,
            joint,
            torque=given.torque,
            diameter=given.wheel_diameter,
            speaker=self.speaker(self.site),
        )

    def _begin(self) -> None:
        self._rate = UpdateRate(self.parameters.update_rate, self.site.now_ns)
        self._drive(0.0, 0.0)

    def _drive(self, left: float, right: float) -> None:
        for wheel in self._left:
            wheel.drive(left)
        for wheel in self._right:
            wheel.drive(right)


def _at_root(site: Site) -> Site:
    """The site, with a namespace of its own only if its tag or who spawned it says one."""
    return dataclasses.replace(site, namespace=site.namespace or "")
