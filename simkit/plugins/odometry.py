"""Odometry: how a robot moved, as the world knows it or as its wheels count it, and how that is published."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from simkit.geometry import Transform, roll_pitch_yaw
from simkit.msgs import Time, message_class
from simkit.physics import Model
from simkit.plugins.site import Site

UNKNOWN = 1e12
"""Variance of what a robot on wheels does not measure."""


@dataclass(frozen=True, slots=True, kw_only=True)
class BaseMotion:
    """Where a robot is, and how it moves."""

    pose: Transform
    """T_odom_base."""
    linear: tuple[float, float]
    """Velocity forward and to the left [m/s]."""
    turning: float
    """Angular velocity about the vertical [rad/s]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Frames:
    """Two frames of which the second hangs on the first."""

    parent: str
    """Where it is seen from; that of odometry is `odom`."""
    child: str
    """What moves."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Covariances:
    """How sure odometry says that it is; 36 numbers each."""

    pose: list[float]
    """Of the pose."""
    twist: list[float]
    """Of the velocities."""


class OdometryPublisher:
    """Says how a robot moves: on a topic, and on /tf.

    Args:
        site: Where the plugin works.
        topic: Global name of a topic of `nav_msgs/Odometry`.
        frames: What moves in what.
        covariances: What is said of the errors.
        on_tf: Whether it is said on /tf too.
    """

    def __init__(
        self, site: Site, topic: str, *, frames: Frames, covariances: Covariances, on_tf: bool
    ) -> None:
        node = site.node
        self._now = node.now
        self._message = odometry_message(frames, covariances)
        self._transform = transform_message(frames)
        self._odometry = node.advertise(topic, message_class("nav_msgs/Odometry"))
        self._tf = node.advertise("/tf", message_class("tf2_msgs/TFMessage")) if on_tf else None

    def publish(self, motion: BaseMotion, *, has_height: bool = True) -> None:
        """Publish.

        Args:
            motion: How it moves now.
            has_height: Whether the message says its height; /tf does at any rate.
        """
        stamp = self._now()
        if self._tf is not None:
            set_transform(self._transform, motion.pose, stamp)
            self._tf.publish(self._tf.message_class([self._transform]))

        def message() -> Any:
            set_motion(self._message, motion, stamp)
            if not has_height:
                self._message.pose.pose.position.z = 0.0
            return self._message

        self._odometry.offer(message)

    def close(self) -> None:
        """Withdraw from the topics."""
        self._odometry.unregister()
        if self._tf is not None:
            self._tf.unregister()


def world_motion(model: Model) -> BaseMotion:
    """How a model moves in truth, seen from the origin of the world.

    Source:
        gazebo_ros_diff_drive: the velocity is turned back by the yaw alone, whatever the tilt.
    """
    pose = model.pose
    (vx, vy, _), (_, _, turning) = model.twist
    yaw = roll_pitch_yaw(pose.rotation)[2]
    cos, sin = math.cos(yaw), math.sin(yaw)
    return BaseMotion(pose=pose, linear=(cos * vx + sin * vy, cos * vy - sin * vx), turning=turning)


def odometry_message(frames: Frames, covariances: Covariances) -> Any:
    """A `nav_msgs/Odometry` that waits for `set_motion`."""
    message: Any = message_class("nav_msgs/Odometry")()
    message.header.frame_id = frames.parent
    message.child_frame_id = frames.child
    message.pose.covariance = covariances.pose
    message.twist.covariance = covariances.twist
    return message


def set_motion(message: Any, motion: BaseMotion, stamp: Time) -> None:
    """Write a motion into a message of odometry."""
    message.header.stamp = stamp
    set_pose(message.pose.pose, motion.pose)
    twist = message.twist.twist
    twist.linear.x, twist.linear.y = motion.linear
    twist.angular.z = motion.turning


def transform_message(frames: Frames) -> Any:
    """A `geometry_msgs/TransformStamped` of T_parent_child that waits for `set_transform`."""
    message: Any = message_class("geometry_msgs/TransformStamped")()
    message.header.frame_id = frames.parent
    message.child_frame_id = frames.child
    return message


def set_transform(message: Any, pose: Transform, stamp: Time) -> None:
    """Write a pose into a message of a transform."""
    message.header.stamp = stamp
    t, q = message.transform.translation, message.transform.rotation
    t.x, t.y, t.z = pose.translation
    q.x, q.y, q.z, q.w = pose.rotation


def set_pose(message: Any, pose: Transform) -> None:
    """Write a pose into a `geometry_msgs/Pose`."""
    position, q = message.position, message.orientation
    position.x, position.y, position.z = pose.translation
    q.x, q.y, q.z, q.w = pose.rotation


def planar_covariance(x: float, y: float, yaw: float) -> list[float]:
    """The 36 numbers of a covariance of which x, y [m^2] and yaw [rad^2] are known."""
    return diagonal_covariance((x, y, UNKNOWN, UNKNOWN, UNKNOWN, yaw))


def diagonal_covariance(variances: tuple[float, float, float, float, float, float]) -> list[float]:
    """The 36 numbers of a covariance in which nothing goes with anything else."""
    return [variances[i] if i == j else 0.0 for i in range(6) for j in range(6)]


class EncoderOdometry:
    """Adds up what two wheels roll; it begins at the origin, wherever the robot stands.

    Args:
        separation: Distance of the wheels that it believes in [m].

    Source:
        gazebo_ros_diff_drive `UpdateOdometryEncoder`, which follows Siegwart, Nourbakhsh and Scaramuzza,
        Introduction to Autonomous Mobile Robots.
    """

    def __init__(self, separation: float) -> None:
        self._separation = separation
        self._x, self._y, self._yaw = 0.0, 0.0, 0.0
        self._speed, self._turning = 0.0, 0.0

    def advance(self, left: float, right: float, seconds: float) -> None:
        """Take account of a step.

        Args:
            left: How far the rim of the left wheel has turned in it [m].
            right: The same of the right wheel.
            seconds: Time of the step [s].
        """
        way, turn = (left + right) / 2.0, (right - left) / self._separation
        dx = way * math.cos(self._yaw + turn / 2.0)
        dy = way * math.sin(self._yaw + turn / 2.0)
        self._x += dx
        self._y += dy
        self._yaw += turn
        # Gazebo's is a length as well: going backwards, it is not negative.
        self._speed = math.sqrt(dx * dx + dy * dy) / seconds
        self._turning = turn / seconds

    def reset(self) -> None:
        """Back to the origin, at rest."""
        self._x, self._y, self._yaw = 0.0, 0.0, 0.0
        self._speed, self._turning = 0.0, 0.0

    @property
    def motion(self) -> BaseMotion:
        """Where the robot should be by now, and how fast."""
        half = self._yaw / 2.0
        rotation = (0.0, 0.0, math.sin(half), math.cos(half))
        return BaseMotion(
            pose=Transform((self._x, self._y, 0.0), rotation),
            linear=(self._speed, 0.0),
            turning=self._turning,
        )
