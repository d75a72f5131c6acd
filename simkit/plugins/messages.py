"""Messages that several plugins publish."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from simkit.geometry import Quaternion, Vector
from simkit.msgs import Time, message_class
from simkit.physics import ModelJoint


def imu_message(
    *,
    stamp_ns: int,
    frame: str,
    orientation: Quaternion,
    angular_velocity: Vector,
    linear_acceleration: Vector,
    noise: float,
) -> Any:
    """The message.

    Args:
        stamp_ns: Time of the measurement [ns].
        frame: Frame of the header.
        orientation: xyzw.
        angular_velocity: [rad/s].
        linear_acceleration: [m/s^2].
        noise: Standard deviation; its square stands in the diagonals of all three covariances.
    """
    message: Any = message_class("sensor_msgs/Imu")()
    message.header.stamp = Time.from_nsec(stamp_ns)
    message.header.frame_id = frame
    turn, rate, push = message.orientation, message.angular_velocity, message.linear_acceleration
    turn.x, turn.y, turn.z, turn.w = orientation
    rate.x, rate.y, rate.z = angular_velocity
    push.x, push.y, push.z = linear_acceleration
    v = noise * noise
    for part in ("orientation", "angular_velocity", "linear_acceleration"):
        setattr(message, f"{part}_covariance", [v, 0.0, 0.0, 0.0, v, 0.0, 0.0, 0.0, v])
    return message


def joint_state_message(joints: Sequence[ModelJoint], stamp: Time, *, with_velocities: bool) -> Any:
    """A `sensor_msgs/JointState` of joints in this order, without efforts.

    Args:
        joints: The joints.
        stamp: The time.
        with_velocities: Whether it says how fast they move.
    """
    message: Any = message_class("sensor_msgs/JointState")()
    message.header.stamp = stamp
    message.name = [joint.name for joint in joints]
    message.position = [joint.position for joint in joints]
    if with_velocities:
        message.velocity = [joint.velocity for joint in joints]
    return message
