"""What drives of wheels have in common: the command that they hear, and the motors of their wheels.

Source: gazebo_ros_diff_drive and gazebo_ros_skid_steer_drive, which agree in it.
"""

from __future__ import annotations

import math
from typing import Any

from simkit.errors import near_names
from simkit.msgs import message_class
from simkit.plugins.errors import PluginError
from simkit.plugins.parameters import place
from simkit.plugins.site import Site

FASTEST = 1e5
"""No motor is asked for more [rad/s]."""


class Wheel:
    """A wheel with a motor that holds a speed, as far as its torque goes; at first it stands.

    Args:
        site: Where the plugin works.
        tag: Tag that names its joint.
        joint: Name of the joint.
        torque: Largest torque of the motor [N m]; the effort limit of the joint does not matter.
        diameter: Diameter of the wheel that the plugin believes in [m].
        speaker: Who complains of a joint that is not there.

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
        """Let the motor hold a speed of the rim [m/s], until it is told another one."""
        speed = min(max(rim_speed / self._radius, -FASTEST), FASTEST)
        self.joint.command_velocity(speed, effort=self._torque)

    def release(self) -> None:
        """Let it roll."""
        self.joint.release()


class TwistEar:
    """Hears how a robot shall move. The last word counts, however long ago it was said.

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
            topic, message_class("geometry_msgs/Twist"), self._hear, queue_size=1
        )

    def rim_speeds(self, separation: float) -> tuple[float, float]:
        """What is asked of the wheels on the left and on the right [m/s].

        Args:
            separation: Distance of the wheels that the plugin believes in [m].
        """
        half = self.angular * separation / 2.0
        return self.linear - half, self.linear + half

    def forget(self) -> None:
        """Let the robot stand until it hears something."""
        self.linear, self.angular = 0.0, 0.0

    def close(self) -> None:
        """Hear no more."""
        self._subscription.unregister()

    def _hear(self, twist: Any) -> None:
        linear, angular = twist.linear.x, twist.angular.z
        if not (math.isfinite(linear) and math.isfinite(angular)):
            self._site.node.warn(
                f"{self._site.name}: a command on {self._subscription.topic} is not obeyed, "
                f"since it holds what is no number: linear.x {linear}, angular.z {angular}"
            )
            return
        self.linear, self.angular = linear, angular


def _no_joint(site: Site, tag: str, joint: str, speaker: str) -> str:
    known = list(site.model.joints)
    near = near_names(joint, known)
    hint = f"; did you mean {near[0]}?" if near else ""
    element = site.element.child(tag) or site.element
    return (
        f"{place(element, site)}: {speaker}: couldn't get wheel hinge joint named {joint}{hint} "
        f"<{tag}> names one of the joints of {site.model.name} that move: {', '.join(known) or 'none'}."
    )
