"""The plugin `libgazebo_ros_diff_drive.so`: two wheels, each with a motor.

Source: gazebo_ros_diff_drive of ROS Melodic and Noetic; gazebo_ros_utils for what it says.
"""

from __future__ import annotations

from typing import ClassVar

from simkit.plugins.joint_state_publisher import TOPIC, JointStateTopic
from simkit.plugins.odometry import (
    Covariances,
    EncoderOdometry,
    Frames,
    OdometryPublisher,
    planar_covariance,
    world_motion,
)
from simkit.plugins.parameters import resolve_frame, shown_namespace, tf_prefix, topic_of
from simkit.plugins.plugin import Plugin
from simkit.plugins.rate import UpdateRate
from simkit.plugins.site import Site
from simkit.plugins.tags import DiffDriveParameters
from simkit.plugins.wheels import MotorWheel, SpeedRamp, TwistListener, WheelTransforms

COVARIANCES = Covariances(pose=planar_covariance(1e-5, 1e-5, 1e-3), twist=[0.0] * 36)
"""What odometry says of its errors, whatever they are."""


class DiffDrive(Plugin[DiffDriveParameters]):
    """Drives a robot as `cmd_vel` says, and reports odometry, wheels and joint states.

    A command holds until the next one: nothing stops the robot when nobody speaks any more. Each
    period of `updateRate` it reports first, and then gives the motors the last command.

    Args:
        site: Where it works.
        parameters: What its tag says.

    Raises:
        PluginError: The model has no such joints, or there can be no such topics.
    """

    Parameters: ClassVar[type[DiffDriveParameters]] = DiffDriveParameters

    def __init__(self, site: Site, parameters: DiffDriveParameters) -> None:
        super().__init__(site, parameters)
        self._left = self._wheel("leftJoint", parameters.left_joint)
        self._right = self._wheel("rightJoint", parameters.right_joint)
        self._encoder = (
            EncoderOdometry(parameters.wheel_separation) if self._has_encoder() else None
        )
        self._ramp = SpeedRamp(parameters.wheel_acceleration)
        self._command_topic = topic_of(site, "commandTopic", parameters.command_topic)
        self._odometry_topic = topic_of(site, "odometryTopic", parameters.odometry_topic)
        self._odometry: OdometryPublisher | None = None
        self._wheels: list[JointStateTopic | WheelTransforms] = []

    @classmethod
    def speaker(cls, site: Site) -> str:
        """Name and namespace, as the original writes them."""
        return f"DiffDrive(ns = {shown_namespace(site)})"

    def on_attach(self) -> None:
        """Advertise, listen, and hold the wheels."""
        if self.site.namespace is None and self.site.element.child("robotNamespace") is None:
            name = self.site.model.name
            self.site.node.info(f"DiffDrive missing <robotNamespace>, defaults is {name}")
        self._advertise()
        self._commands = TwistListener(self.site, self._command_topic)
        self._say(f"Subscribe to {self.parameters.command_topic}")
        self._begin()

    @property
    def due_ns(self) -> int:
        """Each period; with encoders each step, since they count in each."""
        return self._rate.due_ns if self._encoder is None else 0

    def after_step(self) -> None:
        """Count what the wheels rolled; if it is time, report and obey."""
        if self._encoder is not None:
            self._count(self._encoder)
        if self._rate.is_due(self.site.now_ns):
            self._report()
            self._obey()

    def on_reset(self) -> None:
        """Forget the command, and what the encoders counted."""
        self._commands.forget()
        self._ramp.reset()
        if self._encoder is not None:
            self._encoder.reset()
        self._begin()

    def on_detach(self) -> None:
        """Withdraw from all topics, and let the wheels roll."""
        if self._odometry is not None:
            self._odometry.close()
        for report in self._wheels:
            report.close()
        self._commands.close()
        self._left.release()
        self._right.release()

    # -- private

    def _wheel(self, name: str, joint: str) -> MotorWheel:
        given = self.parameters
        return MotorWheel(
            self.site,
            name,
            joint,
            torque=given.wheel_torque,
            diameter=given.wheel_diameter,
            speaker=self.speaker(self.site),
        )

    def _has_encoder(self) -> bool:
        """Whether odometry is what the wheels rolled."""
        source = self.parameters.odometry_source
        if source not in ("world", "encoder"):
            self.site.node.warn(
                f"{self.speaker(self.site)}: <odometrySource> no matching key to {source}; it takes "
                "`world`. There are `world` and `encoder`."
            )
        return source == "encoder"

    def _advertise(self) -> None:
        site, given = self.site, self.parameters
        prefix = tf_prefix(site) or site.robot_namespace
        if given.publish_wheel_joint_state:
            joints = [self._right.joint, self._left.joint]
            self._wheels.append(
                JointStateTopic(site, site.resolve(TOPIC), joints, with_velocities=False)
            )
            self._say("Advertise joint_states")
        if given.publish_wheel_tf:
            self._wheels.insert(0, WheelTransforms(site, prefix, self._right, self._left))
        if given.publish_tf:
            frames = Frames(
                parent=resolve_frame(given.odometry_frame, prefix),
                child=resolve_frame(given.robot_base_frame, prefix),
            )
            self._odometry = OdometryPublisher(
                site,
                self._odometry_topic,
                frames=frames,
                covariances=COVARIANCES,
                on_tf=given.publish_odom_tf,
            )
            self._say(f"Advertise odom on {given.odometry_topic}")

    def _begin(self) -> None:
        self._rate = UpdateRate(self.parameters.update_rate, self.site.now_ns)
        self._rolled = (self._left.rolled, self._right.rolled)
        self._left.drive(0.0)
        self._right.drive(0.0)

    def _report(self) -> None:
        if self._odometry is not None:
            encoder = self._encoder
            self._odometry.publish(
                world_motion(self.site.model) if encoder is None else encoder.motion
            )
        for report in self._wheels:
            report.publish()

    def _count(self, encoder: EncoderOdometry) -> None:
        left, right = self._rolled
        self._rolled = (self._left.rolled, self._right.rolled)
        seconds = self.site.world.step_ns * 1e-9
        encoder.advance(self._rolled[0] - left, self._rolled[1] - right, seconds)

    def _obey(self) -> None:
        targets = self._commands.rim_speeds(self.parameters.wheel_separation)
        measured = (self._left.rim_speed, self._right.rim_speed)
        left, right = self._ramp.next_speeds(targets, measured, self._rate.elapsed_ns * 1e-9)
        self._left.drive(left)
        self._right.drive(right)

    def _say(self, text: str) -> None:
        self.site.node.info(f"{self.speaker(self.site)}: {text}")
