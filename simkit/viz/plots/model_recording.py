"""Records what is true of a model in the world of physics: its pose and its joints, on a timer.

No topic has these: the effort of a joint, and where a robot really is. They are kept as messages, so
that every plot of messages shows them as well.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from simkit.errors import SimkitError, UnknownNameError
from simkit.geometry import Quaternion, Vector
from simkit.graph import Node
from simkit.msgs import Duration, Message, Time, message_class

FASTEST = 1000.0
"""No more samples a second are taken: physics has no more steps."""


class SampledJoint(Protocol):
    """What is sampled of a joint."""

    @property
    def position(self) -> float:
        """[rad or m]."""

    @property
    def velocity(self) -> float:
        """[rad/s or m/s]."""

    @property
    def effort(self) -> float:
        """[N m or N]."""


class SampledPose(Protocol):
    """What is sampled of a pose."""

    @property
    def translation(self) -> Vector:
        """[m]."""

    @property
    def rotation(self) -> Quaternion:
        """Quaternion xyzw."""


class SampledModel(Protocol):
    """What is sampled of a model."""

    @property
    def pose(self) -> SampledPose:
        """In the world."""

    @property
    def joints(self) -> Mapping[str, SampledJoint]:
        """By name."""


class ModelRecording:
    """Samples a model from its creation on, until it is stopped or the model is gone.

    It is read as a recording of topics: `/<name>/joint_states` (sensor_msgs/JointState with efforts)
    and `/<name>/pose` (nav_msgs/Odometry in the frame `world`, without velocities).

    Args:
        node: Its clock is followed.
        name: Name of the model.
        find: Gives the model as long as it is there, then None.
        rate: Samples a second.

    Raises:
        SimkitError: The rate is out of range.
    """

    def __init__(
        self, node: Node, name: str, find: Callable[[], SampledModel | None], *, rate: float
    ) -> None:
        if not 0.0 < rate <= FASTEST:
            raise SimkitError(f"a rate is above 0 and at most {FASTEST:g} Hz, not {rate}")
        self._node, self._find = node, find
        self._joint_state: Any = message_class("sensor_msgs/JointState")
        self._odometry: Any = message_class("nav_msgs/Odometry")
        self._states: list[tuple[Time, Message]] = []
        self._poses: list[tuple[Time, Message]] = []
        self._topics = {f"/{name}/joint_states": self._states, f"/{name}/pose": self._poses}
        self._timer = node.create_timer(Duration.from_sec(1.0 / rate), self._sample)
        self._sample()

    def __getitem__(self, topic: str) -> list[tuple[Time, Message]]:
        """Samples with their times, oldest first.

        Raises:
            UnknownNameError: The topic is neither of the two.
        """
        if topic not in self._topics:
            raise UnknownNameError("recorded topic", topic, self._topics)
        return list(self._topics[topic])

    def topics(self) -> list[str]:
        """The two topics, sorted."""
        return sorted(self._topics)

    def types(self) -> dict[str, str]:
        """Type of the messages of each topic, sorted by name."""
        states, poses = self._topics
        return {states: self._joint_state._type, poses: self._odometry._type}

    def stop(self) -> None:
        """Sample no more; what was sampled stays."""
        self._timer.cancel()

    def _sample(self) -> None:
        model = self._find()
        if model is None:
            self.stop()
            return
        now = self._node.now()
        joints = model.joints
        state = self._joint_state(
            name=list(joints),
            position=[joint.position for joint in joints.values()],
            velocity=[joint.velocity for joint in joints.values()],
            effort=[joint.effort for joint in joints.values()],
        )
        state.header.stamp = now
        self._states.append((now, state))
        self._poses.append((now, self._pose(model.pose, now)))

    def _pose(self, pose: SampledPose, now: Time) -> Message:
        message = self._odometry()
        message.header.stamp, message.header.frame_id = now, "world"
        p, q = message.pose.pose.position, message.pose.pose.orientation
        p.x, p.y, p.z = pose.translation
        q.x, q.y, q.z, q.w = pose.rotation
        found: Message = message
        return found
