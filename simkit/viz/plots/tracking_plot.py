"""How a controller follows its trajectory, as a figure: what it wants, where the joints are, and the error."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from simkit.errors import UnknownNameError
from simkit.msgs import Time
from simkit.viz.draw.letters import shortened
from simkit.viz.plots.plot import Plot, finish, line_color, panels
from simkit.viz.plots.recorded import recorded_topic, timed
from simkit.viz.transform_series import RecordedTopics

if TYPE_CHECKING:
    from matplotlib.figure import Figure

TYPE: Final = "control_msgs/JointTrajectoryControllerState"
"""Type of the messages."""
_LONGEST: Final = 24


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
    """What a joint trajectory controller tells on its topic `state`.

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
        self.topic = recorded_topic(recording, TYPE, topic)
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
            color, label = line_color(number), shortened(joint, _LONGEST)
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
