"""Wheels with motors: commands that they follow, how quickly, and what is reported of them."""

from __future__ import annotations

import math
from typing import Any

from simkit.errors import near_names
from simkit.msgs import message_class
from simkit.plugins.odometry import Frames, set_transform, transform_message
from simkit.plugins.parameters import resolve_frame
from simkit.plugins.site import PluginError, Site

FASTEST = 1e5
"""No motor is asked for more [rad/s]."""


class MotorWheel:
    """A wheel with a motor that holds a speed, as far as its torque goes; at first it stands.

    Args:
        site: Where the plugin works.
        tag: Tag that names its joint.
        joint: Name of the joint.
        torque: Largest torque of the motor [N m]; the effort limit of the joint does not matter.
        diameter: Diameter of the wheel that the plugin believes in [m].
        speaker: Whose name the error about a missing joint begins with.

    Raises:
        PluginError: The model has no such joint.
    """

    def __init__(
        self, site: Site, tag: str, joint: str, *, torque: float, diameter: float, speaker: str
    ) -> None:
        if joint not in site.model.joints:
            raise PluginError(_no_joint(site, tag, joint, speaker))
        self.joint = site.model.joint(joint)
        self._torque = torque
        self._radius = diameter / 2.0

    @property
    def rim_speed(self) -> float:
        """How fast its rim moves about its hub [m/s]."""
        return self.joint.velocity * self._radius

    @property
    def rolled(self) -> float:
        """How far its rim has turned about its hub so far [m]."""
        return self.joint.position * self._radius

    def drive(self, rim_speed: float) -> None:
        """Let the motor hold a speed of the rim [m/s], until the next command."""
        speed = min(max(rim_speed / self._radius, -FASTEST), FASTEST)
        self.joint.command_velocity(speed, effort=self._torque)

    def release(self) -> None:
        """Let it roll."""
        self.joint.release()


class TwistListener:
    """Listens to the commands of a robot. The last one counts, however old it is.

    Args:
        site: Where the plugin works.
        topic: Global name of a topic of `geometry_msgs/Twist`.
    """

    def __init__(self, site: Site, topic: str) -> None:
        self.linear = 0.0
        """Speed forward [m/s]."""
        self.angular = 0.0
        """Angular velocity about the vertical, to the left [rad/s]."""
        self._site = site
        self._subscription = site.node.subscribe(
            topic, message_class("geometry_msgs/Twist"), self._on_twist, queue_size=1
        )

    def rim_speeds(self, separation: float) -> tuple[float, float]:
        """What is asked of the wheels on the left and on the right [m/s].

        Args:
            separation: Distance of the wheels that the plugin believes in [m].
        """
        half = self.angular * separation / 2.0
        return self.linear - half, self.linear + half

    def forget(self) -> None:
        """Let the robot stand until the next command."""
        self.linear, self.angular = 0.0, 0.0

    def close(self) -> None:
        """Unsubscribe."""
        self._subscription.unregister()

    def _on_twist(self, twist: Any) -> None:
        linear, angular = twist.linear.x, twist.angular.z
        if not (math.isfinite(linear) and math.isfinite(angular)):
            self._site.node.warn(
                f"{self._site.name}: a command on {self._subscription.topic} is not obeyed, "
                f"since it holds NaN or infinity: linear.x {linear}, angular.z {angular}"
            )
            return
        self.linear, self.angular = linear, angular


def _no_joint(site: Site, tag: str, joint: str, speaker: str) -> str:
    known = list(site.model.joints)
    near = near_names(joint, known)
    hint = f"; did you mean {near[0]}?" if near else ""
    element = site.element.child(tag) or site.element
    return (
        f"{site.place(element)}: {speaker}: couldn't get wheel hinge joint named {joint}{hint} "
        f"<{tag}> names one of the joints of {site.model.name} that move: {', '.join(known) or 'none'}."
    )


CLOSE = 0.01
"""A wheel that is as near to its target as that counts as being there [m/s]."""


class SpeedRamp:
    """Speeds of two motors on the way to the speeds that are commanded.

    As soon as one of the wheels is near its target, both get theirs; so a wheel may jump, and if
    one has nothing to change, the other one does at once.

    Args:
        limit: Acceleration of a rim [m/s^2]; none if 0.

    Source:
        gazebo_ros_diff_drive `UpdateChild`.
    """

    def __init__(self, limit: float) -> None:
        self._limit = limit
        self._last = (0.0, 0.0)

    def next_speeds(
        self, targets: tuple[float, float], measured: tuple[float, float], seconds: float
    ) -> tuple[float, float]:
        """Speeds of the rims for the motors now, left and right [m/s].

        Args:
            targets: What is asked for [m/s].
            measured: What the wheels do [m/s].
            seconds: Time since the last call [s].
        """
        missing = (targets[0] - measured[0], targets[1] - measured[1])
        if self._limit == 0.0 or min(abs(missing[0]), abs(missing[1])) < CLOSE:
            return targets  # the last ramp stays as it was: the next one goes on from there
        most = self._limit * seconds
        left, right = (
            last + min(max(more, -most), most)
            for last, more in zip(self._last, missing, strict=True)
        )
        self._last = (left, right)
        return self._last

    def reset(self) -> None:
        """Forget the ramp."""
        self._last = (0.0, 0.0)


class WheelTransforms:
    """Tells on /tf where wheels are.

    Each is put on the link that carries it, at the place that it has in the model: as in Gazebo, that is
    right only if that link is the root.

    Args:
        site: Where the plugin works.
        prefix: What stands before the names of frames.
        *wheels: The wheels, in the order of the messages.
    """

    def __init__(self, site: Site, prefix: str, *wheels: MotorWheel) -> None:
        self._site = site
        self._joints = [wheel.joint for wheel in wheels]
        self._publisher = site.node.advertise("/tf", message_class("tf2_msgs/TFMessage"))
        self._messages = [
            transform_message(
                Frames(
                    parent=resolve_frame(joint.plan.parent or "world", prefix),
                    child=resolve_frame(joint.plan.child, prefix),
                )
            )
            for joint in self._joints
        ]

    def publish(self) -> None:
        """Publish a message a wheel."""
        stamp, model = self._site.node.now(), self._site.model
        for joint, message in zip(self._joints, self._messages, strict=True):
            pose = model.pose.inverse() @ model.link_pose(joint.plan.child)
            set_transform(message, pose, stamp)
            self._publisher.publish(self._publisher.message_class([message]))

    def close(self) -> None:
        """Withdraw."""
        self._publisher.unregister()
