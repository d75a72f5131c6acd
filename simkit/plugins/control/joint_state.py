"""JointStateController: publishes on joint_states where the joints are.

Source: joint_state_controller `JointStateController`, texts. `extra_joints` are joints that do not move.
"""

from __future__ import annotations

from typing import Any

from simkit.msgs import Time, message_class
from simkit.plugins.control.controller import Controller, InitError, PublishClock
from simkit.plugins.control.joint_drive import JointHandle

_TYPE = "sensor_msgs/JointState"


class JointStateController(Controller):
    """The controller; it commands no joint."""

    def init(self) -> None:
        """Take all joints.

        Raises:
            InitError: It has no publish_rate.
        """
        if self.parameter("publish_rate") is None:
            raise InitError(
                "Parameter 'publish_rate' not set",
                hint=f"add publish_rate: 50 to {self.name} in the YAML file",
            )
        self._clock = PublishClock(self.number("publish_rate", 0.0))
        joints = self.hardware.joints_of(self.type.interface)
        self._joints = [joints[name] for name in sorted(joints)]
        self._extra = self._extra_joints()
        topic = f"{self.root}/joint_states"
        self._warn_of_others(topic)
        self._publisher = self.advertise(topic, message_class(_TYPE))

    def starting(self, time_ns: int) -> None:
        """The first message comes a period later."""
        self._clock.begin(time_ns)

    def is_due(self, time_ns: int) -> bool:
        """A message."""
        return self._clock.is_due(time_ns)

    def publish(self, time_ns: int) -> None:
        """Publish where the joints are."""
        message: Any = message_class(_TYPE)()
        message.header.stamp = Time.from_nsec(time_ns)
        joints = (*self._joints, *self._extra)
        message.name = [one.name for one in joints]
        message.position = [one.position for one in joints]
        message.velocity = [one.velocity for one in joints]
        message.effort = [one.effort for one in joints]
        self._publisher.publish(message)

    def _warn_of_others(self, topic: str) -> None:
        """Name who publishes the positions already: with two of them a robot flickers in RViz."""
        found = self.node.graph.topics.get(topic)
        others = sorted({one.node_name for one in found.publishers}) if found else []
        if others:
            what = "a plugin of the robot" if others == [self.node.name] else ", ".join(others)
            self.node.warn(
                f"hint: {what} publishes {topic} already, and {self.name} does now: keep one of them, or "
                "the robot may flicker between two poses"
            )

    def _extra_joints(self) -> list[JointHandle]:
        """Joints that nobody moves, for the parameter `extra_joints`."""
        given = self.parameter("extra_joints", [])
        if not isinstance(given, list):
            raise InitError(f"The parameter {self.namespace}/extra_joints must be a list")
        return [self._extra_joint(one) for one in given]

    def _extra_joint(self, given: Any) -> JointHandle:
        if not isinstance(given, dict) or "name" not in given:
            raise InitError(f"Extra joint {given!r} has no name (namespace: {self.namespace}).")
        numbers = [given.get(key, 0.0) for key in ("position", "velocity", "effort")]
        if not all(isinstance(one, int | float) for one in numbers):
            raise InitError(f"Extra joint {given!r} has a value that is no number.")
        position, velocity, effort = map(float, numbers)
        return JointHandle(str(given["name"]), self.type.interface, position, velocity, effort)
