"""JointStateController: says on joint_states where the joints are.

Source: joint_state_controller `JointStateController`, texts. `extra_joints` are joints that do not move.
"""

from __future__ import annotations

from typing import Any

from simkit.msgs import message_class
from simkit.plugins.control.controller import Controller, Due, stamp
from simkit.plugins.control.joint_drive import JointHandle
from simkit.plugins.control.place import ControllerPlace, InitError

_TYPE = "sensor_msgs/JointState"


class JointStateController(Controller):
    """The controller; it commands no joint.

    Args:
        place: Its parameters, joints and topics.

    Raises:
        InitError: It has no publish_rate.
    """

    def __init__(self, place: ControllerPlace) -> None:
        super().__init__(place)
        if place.parameter("publish_rate") is None:
            raise InitError(
                "Parameter 'publish_rate' not set",
                hint=f"add publish_rate: 50 to {place.name} in the YAML file",
            )
        self._due = Due(place.number("publish_rate", 0.0))
        joints = place.hardware.joints_of(place.interface)
        self._joints = [joints[name] for name in sorted(joints)]
        self._extra = _extra_joints(place)
        topic = f"{place.root}/joint_states"
        _warn_of_others(place, topic)
        self._publisher = place.advertise(topic, message_class(_TYPE))

    def starting(self, time_ns: int) -> None:
        """The first message comes a period later."""
        self._due.begin(time_ns)

    def is_due(self, time_ns: int) -> bool:
        """A message."""
        return self._due.at(time_ns)

    def publish(self, time_ns: int) -> None:
        """Say where the joints are."""
        message: Any = message_class(_TYPE)()
        message.header.stamp = stamp(time_ns)
        joints = (*self._joints, *self._extra)
        message.name = [one.name for one in joints]
        message.position = [one.position for one in joints]
        message.velocity = [one.velocity for one in joints]
        message.effort = [one.effort for one in joints]
        self._publisher.publish(message)


def _warn_of_others(place: ControllerPlace, topic: str) -> None:
    """Say who publishes the positions already: with two of them a robot flickers in RViz."""
    found = place.node.graph.topics.get(topic)
    others = sorted({one.node_name for one in found.publishers}) if found else []
    if others:
        what = "a plugin of the robot" if others == [place.node.name] else ", ".join(others)
        place.node.warn(
            f"hint: {what} publishes {topic} already, and {place.name} does now: keep one of them, or the "
            "robot may flicker between two poses"
        )


def _extra_joints(place: ControllerPlace) -> list[JointHandle]:
    """Joints that nobody moves, for the parameter `extra_joints`."""
    given = place.parameter("extra_joints", [])
    if not isinstance(given, list):
        raise InitError(f"The parameter {place.namespace}/extra_joints must be a list")
    return [_extra_joint(place, one) for one in given]


def _extra_joint(place: ControllerPlace, given: Any) -> JointHandle:
    if not isinstance(given, dict) or "name" not in given:
        raise InitError(f"Extra joint {given!r} has no name (namespace: {place.namespace}).")
    numbers = [given.get(key, 0.0) for key in ("position", "velocity", "effort")]
    if not all(isinstance(one, int | float) for one in numbers):
        raise InitError(f"Extra joint {given!r} has a value that is no number.")
    position, velocity, effort = map(float, numbers)
    return JointHandle(str(given["name"]), place.interface, position, velocity, effort)
