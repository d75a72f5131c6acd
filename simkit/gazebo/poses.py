"""Poses and twists between messages and the world."""

from __future__ import annotations

import math
from typing import Any

from simkit.geometry import IDENTITY, Transform, Vector
from simkit.msgs import message_class


def vector_of(message: Any) -> Vector:
    """A vector or point of a message."""
    return (message.x, message.y, message.z)


def transform_of_message(pose: Any) -> Transform:
    """The pose of a message; a quaternion of zeros, as in a request left empty, turns nothing."""
    q = pose.orientation
    norm = math.sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w)
    rotation = IDENTITY
    if norm > 0.0 and math.isfinite(norm):
        rotation = (q.x / norm, q.y / norm, q.z / norm, q.w / norm)
    return Transform(vector_of(pose.position), rotation)


def pose_message(placement: Transform) -> Any:
    """A `geometry_msgs/Pose`."""
    pose: Any = message_class("geometry_msgs/Pose")()
    pose.position.x, pose.position.y, pose.position.z = placement.translation
    q = pose.orientation
    q.x, q.y, q.z, q.w = placement.rotation
    return pose


def twist_message(twist: tuple[Vector, Vector]) -> Any:
    """A `geometry_msgs/Twist` of a linear [m/s] and an angular velocity [rad/s]."""
    message: Any = message_class("geometry_msgs/Twist")()
    linear, angular = twist
    message.linear.x, message.linear.y, message.linear.z = linear
    message.angular.x, message.angular.y, message.angular.z = angular
    return message
