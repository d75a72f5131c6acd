"""Recordings as figures: frames, joints, how a controller tracks, paths over the ground."""

from __future__ import annotations

import weakref
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from simkit.graph.recording import Recording
    from simkit.simulation.simulation import Simulation
    from simkit.viz import JointPlot, ModelRecording, PathPlot, TrackingPlot, TransformPlot


class Plots:
    """The part of a `Simulation` that plots recordings.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)

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
