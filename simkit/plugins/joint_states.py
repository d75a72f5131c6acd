"""The message that says where joints stand."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from simkit.msgs import Time, message_class
from simkit.physics import ModelJoint


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
