"""Recordings: of topics, of a model, of the whole world; and figures of them."""

from __future__ import annotations

import weakref
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.graph.recording import Recording
from simkit.simulation.world_window import world_to_see

if TYPE_CHECKING:
    from simkit.physics import Model
    from simkit.simulation.simulation import Simulation
    from simkit.viz import (
        JointPlot,
        ModelRecording,
        PathPlot,
        TrackingPlot,
        TransformPlot,
        WorldTape,
    )


class Recorder:
    """The part of a `Simulation` that records, and plots what was recorded.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

    def record(self, topics: Iterable[str] | Mapping[str, str]) -> Recording:
        """Record topics from now on.

        Args:
            topics: Names of topics in use, or names with types for topics that are still to come.

        Raises:
            UnknownNameError: A topic is not in use and no type is given.
        """
        return Recording(self._sim.node, self._sim.graph_client.message_classes(topics))

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

        gazebo = self._sim.gazebo
        if name not in gazebo.spawned:
            raise UnknownNameError("model in the world", name, gazebo.spawned)
        recorded = gazebo.spawned[name]

        def find() -> Model | None:
            # Another model of the same name is another model.
            return recorded.model if gazebo.spawned.get(name) is recorded else None

        return ModelRecording(self._sim.node, name, find, rate=rate)

    def record_world(self, *, rate: float = 30.0) -> WorldTape:
        """Record where all links and joints are from now on, what touches, and what lasers see.

        Args:
            rate: How often to look [Hz of virtual time], rounded to whole milliseconds.

        Returns:
            A recording with `link(model, link)`, `joint(model, joint)`, `contacts`, `scans`, `stop()`.

        Raises:
            SimkitError: There is no world, or the rate makes no sense.
        """
        from simkit.viz import WorldTape

        gazebo = world_to_see(self._sim)
        return WorldTape(gazebo, gazebo.node, rate=rate)

    def joint_plot(
        self,
        recording: Recording | ModelRecording,
        *,
        topic: str | None = None,
        joints: Collection[str] | None = None,
    ) -> JointPlot:
        """Position, velocity and effort of joints over virtual time, as far as they were published.

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

    def tf_plot(
        self, target: str, source: str, *, recording: Recording | None = None
    ) -> TransformPlot:
        """Where `source` was, seen from `target`, over virtual time.

        Args:
            target: Frame to express it in.
            source: Frame to follow.
            recording: Of /tf and /tf_static; the last ten seconds of the buffer if None.
        """
        from simkit.viz import TransformPlot

        data = self._sim.tf if recording is None else recording
        return TransformPlot(data, target=target, source=source)
