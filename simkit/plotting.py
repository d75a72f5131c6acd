"""Recordings as figures: joints, how a controller tracks, ways over the ground."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.graph import Node

if TYPE_CHECKING:
    from simkit.gazebo import Gazebo
    from simkit.physics import Model
    from simkit.recording import Recording
    from simkit.viz import JointPlot, ModelRecording, PathPlot, TrackingPlot


class Plotting:
    """The part of `Simulation` that plots recordings, and records what no topic tells."""

    _node: Node

    @property
    def gazebo(self) -> Gazebo:
        """The world of physics."""
        raise NotImplementedError

    def record_model(self, name: str, *, rate: float = 100.0) -> ModelRecording:
        """Record a model of the world from now on: its true pose; position, velocity, effort of its joints.

        Args:
            name: Name of the model in the world.
            rate: Samples a second of virtual time.

        Raises:
            UnknownNameError: No such model is in the world.
            SimkitError: The rate is out of range.
        """
        from simkit.viz import ModelRecording

        gazebo = self.gazebo
        if name not in gazebo.spawned:
            raise UnknownNameError("model in the world", name, gazebo.spawned)
        recorded = gazebo.spawned[name]

        def find() -> Model | None:
            # Another model of the same name is another model.
            return recorded.model if gazebo.spawned.get(name) is recorded else None

        return ModelRecording(self._node, name, find, rate=rate)

    def joint_plot(
        self,
        recording: Recording | ModelRecording,
        *,
        topic: str | None = None,
        joints: Collection[str] | None = None,
    ) -> JointPlot:
        """Position, velocity and effort of joints over virtual time, as far as they were told.

        Args:
            recording: Of /joint_states, or what `record_model` has made, which has the efforts.
            topic: Name of the topic; the only recorded one of sensor_msgs/JointState if None.
            joints: Names of the joints; all if None.

        Raises:
            UnknownNameError: A joint or the topic was not recorded.
            SimkitError: There is nothing of that type.
        """
        from simkit.viz import JointPlot

        return JointPlot(recording, topic=topic, joints=joints)

    def tracking_plot(
        self,
        recording: Recording,
        *,
        topic: str | None = None,
        joints: Collection[str] | None = None,
    ) -> TrackingPlot:
        """How a trajectory controller follows: desired and actual positions, and the error.

        Args:
            recording: Of its topic `state`, e.g. `sim.record(["/arm_controller/state"])`.
            topic: Name of the topic; the only recorded one of its type if None.
            joints: Names of the joints; all if None.

        Raises:
            UnknownNameError: A joint or the topic was not recorded.
            SimkitError: There is nothing of that type.
        """
        from simkit.viz import TrackingPlot

        return TrackingPlot(recording, topic=topic, joints=joints)

    def path_plot(
        self,
        recording: Recording | ModelRecording,
        *,
        topics: Sequence[str] | None = None,
        truth: Recording | ModelRecording | str | None = None,
        align: bool = True,
    ) -> PathPlot:
        """Where odometry says that a robot went, and where it went, seen from above.

        Args:
            recording: Of topics of nav_msgs/Odometry, e.g. `/odom`.
            topics: Their names; all of that type if None.
            truth: The true way: what `record_model` has made, or the name of another topic of the recording.
            align: Whether the true way is moved to begin where odometry does, which counts from there.

        Raises:
            UnknownNameError: A topic was not recorded.
            SimkitError: There is nothing of that type.
        """
        from simkit.viz import PathPlot

        return PathPlot(recording, topics=topics, truth=truth, align=align)
