"""The plugin `libgazebo_ros_joint_state_publisher.so`: publishes the positions of joints of a model.

Source: gazebo_ros_joint_state_publisher of ROS Melodic and Noetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, ClassVar

from simkit.errors import near_names
from simkit.msgs import message_class
from simkit.physics import ModelJoint
from simkit.plugins.parameters import shown_namespace, topic_of
from simkit.plugins.plugin import Plugin
from simkit.plugins.rate import UpdateRate
from simkit.plugins.site import PluginError, Site
from simkit.plugins.tags import JointStatePublisherParameters

TOPIC = "joint_states"
"""In the namespace of the robot."""


class JointStateTopic:
    """Publishes where joints stand, without efforts.

    Args:
        site: Where the plugin works.
        topic: Global name of the topic.
        joints: The joints, in the order of the message.
        with_velocities: Whether it says how fast they move.
    """

    def __init__(
        self, site: Site, topic: str, joints: Sequence[ModelJoint], *, with_velocities: bool
    ) -> None:
        self._now = site.node.now
        self._joints = joints
        self._with_velocities = with_velocities
        self._publisher = site.node.advertise(topic, message_class("sensor_msgs/JointState"))
        self._message: Any = self._publisher.message_class()
        self._message.name = [joint.name for joint in joints]

    def publish(self) -> None:
        """Publish where they stand now."""
        stamp, positions = self._now(), [joint.position for joint in self._joints]
        moving = self._joints if self._with_velocities else ()
        velocities = [joint.velocity for joint in moving]

        def message() -> Any:
            self._message.header.stamp = stamp
            self._message.position, self._message.velocity = positions, velocities
            return self._message

        self._publisher.offer(message)

    def close(self) -> None:
        """Withdraw."""
        self._publisher.unregister()


class GazeboJointStatePublisher(Plugin[JointStatePublisherParameters]):
    """Publishes positions and velocities of the joints that it is given, in that order.

    Positions are counted on through whole turns. A joint that is not in the list is not in the message,
    and has no transform then.

    Args:
        site: Where it works.
        parameters: What its tag says.

    Raises:
        PluginError: The model has no joint of a name, or it does not move.
    """

    Parameters: ClassVar[type[JointStatePublisherParameters]] = JointStatePublisherParameters

    def __init__(self, site: Site, parameters: JointStatePublisherParameters) -> None:
        super().__init__(site, parameters)
        self._topic = topic_of(site, "robotNamespace", TOPIC)
        # Spaces go, as in Gazebo; ends of lines stay, and spoil a name.
        names = parameters.joint_name.strip().replace(" ", "").split(",")
        self._joints = [self._joint(name) for name in names]

    @classmethod
    def speaker(cls, site: Site) -> str:
        """Name and namespace, as the original writes them."""
        return f"GazeboRosJointStatePublisher Plugin (ns = {shown_namespace(site)})"

    def on_attach(self) -> None:
        """Advertise."""
        site = self.site
        for joint in self._joints:
            site.node.info(f"GazeboRosJointStatePublisher is going to publish joint: {joint.name}")
        self._states = JointStateTopic(site, self._topic, self._joints, with_velocities=True)
        self._begin()

    @property
    def due_ns(self) -> int:
        """Each period."""
        return self._rate.due_ns

    def after_step(self) -> None:
        """Publish, if it is time."""
        if self._rate.is_due(self.site.now_ns):
            self._states.publish()

    def on_reset(self) -> None:
        """Count its period anew."""
        self._begin()

    def on_detach(self) -> None:
        """Withdraw."""
        self._states.close()

    def _begin(self) -> None:
        self._rate = UpdateRate(self.parameters.update_rate, self.site.now_ns)

    def _joint(self, name: str) -> ModelJoint:
        known = self.site.model.joints
        if name in known:
            return known[name]
        element = self.site.element.child("jointName") or self.site.element
        raise PluginError(
            f"{self.site.place(element)}: Joint {name.strip() or repr(name)} does not exist! {_remedy(name, known)}Joints "
            f"of {self.site.model.name} that move: {', '.join(known) or 'none'}."
        )


def _remedy(name: str, known: Iterable[str]) -> str:
    """What may be wrong with a name, and a space."""
    if not name.strip():
        return "There is a comma too many in the list. "
    if name != name.strip():
        return "Gazebo takes no line breaks or tabs in the list: write it in one line. "
    near = near_names(name, known)
    return f"Did you mean {near[0]}? " if near else ""
