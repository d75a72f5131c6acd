"""A transform over time as a figure: position and yaw over virtual seconds."""

from __future__ import annotations

from typing import TYPE_CHECKING

from simkit.tf import Buffer
from simkit.viz.draw.letters import shortened
from simkit.viz.plots.plot import Plot, finish, panels
from simkit.viz.transform_series import RecordedTopics, TransformSeries, transform_series

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_COLORS = {"x": "#d92d2d", "y": "#21913c", "z": "#2b6fe0", "yaw": "#7a4fb5"}
# Where two lines are one, the gaps of the upper show the lower; and red and green look alike to some.
_STYLES = {"x": "-", "y": (0, (7, 3)), "z": (0, (2, 2)), "yaw": "-"}
_LONGEST = 40


class TransformPlot(Plot):
    """x, y, z and yaw of one frame seen from another.

    Args:
        transforms: A buffer, which reaches 10 s back, or a recording of /tf (and /tf_static).
        target: The frame it is seen from.
        source: The frame that is seen.

    Attributes:
        series: The numbers that are plotted.

    Raises:
        TransformException: There is no way between the frames; `hint` says what to do.
    """

    def __init__(self, transforms: Buffer | RecordedTopics, *, target: str, source: str) -> None:
        self.series: TransformSeries = transform_series(transforms, target=target, source=source)

    @property
    def title(self) -> str:
        """Which frame it shows, and from where."""
        return _title(self.series)

    def figure(self) -> Figure:
        """Position above, yaw below."""
        return _figure(self.series)


def _title(series: TransformSeries) -> str:
    source, target = (shortened(name, _LONGEST) for name in (series.source, series.target))
    return f'"{source}" seen from "{target}"'


def _figure(series: TransformSeries) -> Figure:
    figure, (above, below) = panels(_title(series), (3, 2))
    for name, values in (("x", series.x), ("y", series.y), ("z", series.z)):
        _draw(above, series.seconds, values, name)
    above.set_ylabel("position [m]")
    _draw(below, series.seconds, series.yaw, "yaw")
    below.set_ylabel("yaw [rad]")
    below.set_xlabel(_time_label(series))
    finish((above, below))
    return figure


def _draw(axes: Axes, seconds: tuple[float, ...], values: tuple[float, ...], name: str) -> None:
    if len(values) == 1:
        seconds, values = (0.0, 1.0), values * 2
    axes.plot(seconds, values, color=_COLORS[name], linestyle=_STYLES[name], label=name)


def _time_label(series: TransformSeries) -> str:
    if not series.start:
        return "virtual time [s]; a static transform, the same at every time"
    return f"virtual time [s] since {series.start.to_sec():.3f}"
