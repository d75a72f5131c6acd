"""Joints over time, as numbers and as figures: what they did, and how a controller follows its trajectory."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.viz.draw.letters import abbreviated
from simkit.viz.plots.plot import (
    Plot,
    RecordedTopics,
    finish,
    line_color,
    panels,
    recorded_topic,
    timed,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_JOINT_STATE: Final = "sensor_msgs/JointState"
"""Type of the messages."""
QUANTITIES: Final = ("position", "velocity", "effort")
"""What a message may tell of each joint."""

Row = tuple[float, float]
"""Time since the start [s], value."""


@dataclass(frozen=True, slots=True, kw_only=True)
class JointSeries:
    """Recorded states of some joints."""

    topic: str
    """Their topic."""
    start: Time
    """Time of the first message."""
    position: Mapping[str, tuple[Row, ...]]
    """Position of each joint that has one [rad or m]."""
    velocity: Mapping[str, tuple[Row, ...]]
    """Velocity of each joint that has one [rad/s or m/s]."""
    effort: Mapping[str, tuple[Row, ...]]
    """Effort of each joint that has one [N m or N]."""


def joint_series(
    recording: RecordedTopics, *, topic: str | None = None, joints: Collection[str] | None = None
) -> JointSeries:
    """Position, velocity and effort of joints, as far as they were published.

    Args:
        recording: Has messages of sensor_msgs/JointState.
        topic: Their topic; the only one of that type if None.
        joints: Names of the joints; all if None.

    Raises:
        UnknownNameError: A joint or the topic was not recorded.
        SimkitError: There is nothing of that type.
    """
    name = recorded_topic(recording, _JOINT_STATE, topic)
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


_UNITS: Final = {
    "position": "position [rad, m]",
    "velocity": "velocity [rad/s, m/s]",
    "effort": "effort [N m, N]",
}
_LONGEST: Final = 24


class JointPlot(Plot):
    """Joints as sensor_msgs/JointState has them.

    Args:
        recording: Of a topic of that type, or of a model.
        topic: Its name; the only one of that type if None.
        joints: Names of the joints; all if None.

    Attributes:
        series: The numbers that are plotted.

    Raises:
        UnknownNameError: A joint or the topic was not recorded.
        SimkitError: There is nothing of that type.
    """

    def __init__(
        self,
        recording: RecordedTopics,
        *,
        topic: str | None = None,
        joints: Collection[str] | None = None,
    ) -> None:
        self.series: JointSeries = joint_series(recording, topic=topic, joints=joints)

    @property
    def title(self) -> str:
        """The topic of the joints."""
        return f"joints on {self.series.topic}"

    def figure(self) -> Figure:
        """One panel for each quantity that was published."""
        shown = [(name, getattr(self.series, name)) for name in QUANTITIES]
        shown = [(name, rows) for name, rows in shown if rows] or shown[:1]
        numbers = {joint: n for n, joint in enumerate(self._joints())}
        figure, axes = panels(self.title, [1] * len(shown))
        for one, (name, rows) in zip(axes, shown, strict=True):
            for joint, row in rows.items():
                seconds, values = zip(*row, strict=True)
                color = line_color(numbers[joint])
                # The colours are the same in each panel; the first one explains them.
                label = abbreviated(joint, _LONGEST) if one is axes[0] else None
                one.plot(seconds, values, color=color, label=label, linewidth=1.3)
            one.set_ylabel(_UNITS[name])
        axes[-1].set_xlabel(f"virtual time [s] since {self.series.start.to_sec():.3f}")
        finish(axes)
        return figure

    def _joints(self) -> list[str]:
        series = self.series
        return list(dict.fromkeys([*series.position, *series.velocity, *series.effort]))


_CONTROLLER_STATE: Final = "control_msgs/JointTrajectoryControllerState"
"""Type of the messages."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Tracking:
    """One joint of a controller over time."""

    seconds: tuple[float, ...]
    """Time since the start [s]."""
    desired: tuple[float, ...]
    """Where it should be [rad or m]."""
    actual: tuple[float, ...]
    """Where it is [rad or m]."""
    error: tuple[float, ...]
    """What is between, as the controller says [rad or m]."""


class TrackingPlot(Plot):
    """What a joint trajectory controller publishes on its topic `state`.

    Args:
        recording: Of that topic.
        topic: Its name, e.g. `/arm_controller/state`; the only one of that type if None.
        joints: Names of the joints; all if None.

    Attributes:
        topic: Name of the topic.
        start: Time of the first message.
        joints: The numbers that are plotted, by joint.

    Raises:
        UnknownNameError: A joint or the topic was not recorded.
        SimkitError: There is nothing of that type.
    """

    def __init__(
        self,
        recording: RecordedTopics,
        *,
        topic: str | None = None,
        joints: Collection[str] | None = None,
    ) -> None:
        self.topic = recorded_topic(recording, _CONTROLLER_STATE, topic)
        messages = list(timed(recording, self.topic))
        start = min(time for time, _ in messages)
        rows: dict[str, list[tuple[float, float, float, float]]] = {}
        for time, state in messages:
            columns = (state.desired.positions, state.actual.positions, state.error.positions)
            for joint, *values in zip(state.joint_names, *columns, strict=False):
                desired, actual, error = values
                rows.setdefault(joint, []).append(((time - start) / 1e9, desired, actual, error))
        for joint in joints or ():
            if joint not in rows:
                raise UnknownNameError(f"joint on {self.topic}", joint, rows)
        self.start = Time.from_nsec(start)
        self.joints: dict[str, Tracking] = {
            joint: _tracking(rows[joint]) for joint in (rows if joints is None else joints)
        }

    @property
    def title(self) -> str:
        """The controller, and its greatest error."""
        errors = [abs(error) for one in self.joints.values() for error in one.error]
        return f"{self.topic}: greatest error {max(errors, default=0.0):.3g}"

    def figure(self) -> Figure:
        """Desired and actual position above, the error below."""
        figure, (above, below) = panels(self.title, (3, 2))
        for number, (joint, rows) in enumerate(self.joints.items()):
            color, label = line_color(number), abbreviated(joint, _LONGEST)
            above.plot(rows.seconds, rows.actual, color=color, label=label, linewidth=1.3)
            # The gaps of the broken line show the other where both are one.
            above.plot(
                rows.seconds, rows.desired, color="#1d2733", linestyle=(0, (2, 3)), linewidth=1.6
            )
            below.plot(rows.seconds, rows.error, color=color, linewidth=1.3)
        above.plot([], [], color="#1d2733", linestyle=(0, (2, 3)), label="desired")
        above.set_ylabel("position [rad, m]")
        below.set_ylabel("error [rad, m]")
        below.set_xlabel(f"virtual time [s] since {self.start.to_sec():.3f}")
        finish((above, below))
        return figure


def _tracking(rows: list[tuple[float, float, float, float]]) -> Tracking:
    seconds, desired, actual, error = zip(*rows, strict=True)
    return Tracking(seconds=seconds, desired=desired, actual=actual, error=error)
