"""What a drive tells of its wheels."""

from __future__ import annotations

from typing import Any

from simkit.msgs import Time, message_class
from simkit.physics import ModelJoint
from simkit.plugins.joint_states import joint_state_message
from simkit.plugins.naming import resolve_frame
from simkit.plugins.odometry import Frames, transform_message
from simkit.plugins.site import Site
from simkit.plugins.wheels import Wheel


class WheelStates:
    """Tells on `joint_states` how far wheels have turned.

    Args:
        site: Where the plugin works.
        *wheels: The wheels, in the order of the message.
    """

    def __init__(self, site: Site, *wheels: Wheel) -> None:
        self._now = site.node.now
        self._joints = [wheel.joint for wheel in wheels]
        self._publisher = site.node.advertise(
            site.resolve("joint_states"), message_class("sensor_msgs/JointState")
        )

    def say(self) -> None:
        """Publish."""
        message = joint_state_message(self._joints, self._now(), with_velocities=False)
        self._publisher.publish(message)

    def close(self) -> None:
        """Withdraw."""
        self._publisher.unregister()


class WheelTransforms:
    """Tells on /tf where wheels are.

    Each is put on the link that carries it, at the place that it has in the model: as in Gazebo, that is
    right only if that link is the root.

    Args:
        site: Where the plugin works.
        prefix: What stands before the names of frames.
        *wheels: The wheels, in the order of the messages.
    """

    def __init__(self, site: Site, prefix: str, *wheels: Wheel) -> None:
        self._site = site
        self._prefix = prefix
        self._joints = [wheel.joint for wheel in wheels]
        self._publisher = site.node.advertise("/tf", message_class("tf2_msgs/TFMessage"))

    def say(self) -> None:
        """Publish a message a wheel."""
        stamp = self._site.node.now()
        for joint in self._joints:
            moved = self._transform(joint, stamp)
            self._publisher.publish(self._publisher.message_class([moved]))

    def close(self) -> None:
        """Withdraw."""
        self._publisher.unregister()

    def _transform(self, joint: ModelJoint, stamp: Time) -> Any:
        plan, model = joint.plan, self._site.model
        frames = Frames(
            parent=resolve_frame(plan.parent or "world", self._prefix),
            child=resolve_frame(plan.child, self._prefix),
        )
        pose = model.pose.inverse() @ model.link_pose(plan.child)
        return transform_message(pose, frames, stamp)
