"""Joints over time as a figure: position, velocity and effort over virtual seconds."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Final

from simkit.viz.draw.letters import shortened
from simkit.viz.plots.joint_series import QUANTITIES, JointSeries, joint_series
from simkit.viz.plots.plot import Plot, finish, line_color, panels
from simkit.viz.transform_series import RecordedTopics

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_UNITS: Final = {
    "position": "position [rad, m]",
    "velocity": "velocity [rad/s, m/s]",
    "effort": "effort [N m, N]",
}
_LONGEST: Final = 24


class JointPlot(Plot):
    """What sensor_msgs/JointState told of joints.

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
        """Where the joints were told of."""
        return f"joints on {self.series.topic}"

    def figure(self) -> Figure:
        """One panel for each quantity that was told."""
        shown = [(name, getattr(self.series, name)) for name in QUANTITIES]
        shown = [(name, rows) for name, rows in shown if rows] or shown[:1]
        numbers = {joint: n for n, joint in enumerate(self._joints())}
        figure, axes = panels(self.title, [1] * len(shown))
        for one, (name, rows) in zip(axes, shown, strict=True):
            for joint, row in rows.items():
                seconds, values = zip(*row, strict=True)
                color = line_color(numbers[joint])
                # The colours are the same in each panel; the first one explains them.
                label = shortened(joint, _LONGEST) if one is axes[0] else None
                one.plot(seconds, values, color=color, label=label, linewidth=1.3)
            one.set_ylabel(_UNITS[name])
        axes[-1].set_xlabel(f"virtual time [s] since {self.series.start.to_sec():.3f}")
        finish(axes)
        return figure

    def _joints(self) -> list[str]:
        series = self.series
        return list(dict.fromkeys([*series.position, *series.velocity, *series.effort]))
