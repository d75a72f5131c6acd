"""Joints over time, as numbers to plot: what sensor_msgs/JointState told."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any, Final

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.viz.plots.recorded import recorded_topic, timed
from simkit.viz.transform_series import RecordedTopics

TYPE: Final = "sensor_msgs/JointState"
"""Type of the messages."""
QUANTITIES: Final = ("position", "velocity", "effort")
"""What a message may tell of each joint."""

Row = tuple[float, float]
"""Time since the start [s], value."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointSeries:
    """What was told of some joints."""

    topic: str
    """Where it was told."""
    start: Time
    """Time of the first message."""
    position: Mapping[str, tuple[Row, ...]]
    """Position of each joint that one was told of [rad or m]."""
    velocity: Mapping[str, tuple[Row, ...]]
    """Velocity of each joint that one was told of [rad/s or m/s]."""
    effort: Mapping[str, tuple[Row, ...]]
    """Effort of each joint that one was told of [N m or N]."""


def joint_series(
    recording: RecordedTopics, *, topic: str | None = None, joints: Collection[str] | None = None
) -> JointSeries:
    """Position, velocity and effort of joints, as far as they were told.

    Args:
        recording: Has messages of sensor_msgs/JointState.
        topic: Their topic; the only one of that type if None.
        joints: Names of the joints; all if None.

    Raises:
        UnknownNameError: A joint or the topic was not recorded.
        SimkitError: There is nothing of that type.
    """
    name = recorded_topic(recording, TYPE, topic)
    rows: dict[str, dict[str, list[Row]]] = {quantity: {} for quantity in QUANTITIES}
    messages = list(timed(recording, name))
    start = min(time for time, _ in messages)
    for time, message in messages:
        for quantity in QUANTITIES:
            _add(rows[quantity], (time - start) / 1e9, message, quantity)
    known = sorted({joint for found in rows.values() for joint in found})
    for joint in joints or ():
        if joint not in known:
            raise UnknownNameError(f"joint on {name}", joint, known)
    wanted = known if joints is None else list(joints)
    position, velocity, effort = (
        {joint: tuple(rows[quantity][joint]) for joint in wanted if joint in rows[quantity]}
        for quantity in QUANTITIES
    )
    return JointSeries(
        topic=name,
        start=Time.from_nsec(start),
        position=position,
        velocity=velocity,
        effort=effort,
    )


def _add(rows: dict[str, list[Row]], time: float, message: Any, quantity: str) -> None:
    # A message may leave a quantity out: then its list is empty.
    for joint, value in zip(message.name, getattr(message, quantity), strict=False):
        rows.setdefault(joint, []).append((time, value))
