"""Ways over the ground, as numbers and as a figure: where odometry says that a robot went, and where it went."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Final

from simkit.errors import SimkitError
from simkit.geometry import roll_pitch_yaw
from simkit.viz.draw.letters import abbreviated
from simkit.viz.plots.plot import (
    Plot,
    RecordedTopics,
    finish,
    line_color,
    recorded_topic,
    timed,
    topics_of,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ODOMETRY: Final = "nav_msgs/Odometry"
"""Type of the messages."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PathSeries:
    """One way."""

    name: str
    """Its topic."""
    frame: str
    """The frame that it is given in."""
    times: tuple[int, ...]
    """Time of each pose [ns]."""
    x: tuple[float, ...]
    """x of each pose [m]."""
    y: tuple[float, ...]
    """y of each pose [m]."""
    yaw: tuple[float, ...]
    """Turn of each pose about z [rad]."""

    def at(self, time: int) -> tuple[float, float, float]:
        """x, y [m] and yaw [rad] at a time [ns], straight between two poses; before the first, the first."""
        after = bisect_right(self.times, time)
        if after in (0, len(self.times)):
            index = min(after, len(self.times) - 1)
            return self.x[index], self.y[index], self.yaw[index]
        start, end = self.times[after - 1], self.times[after]
        share = (time - start) / (end - start)
        x, y = (row[after - 1] + share * (row[after] - row[after - 1]) for row in (self.x, self.y))
        turn = math.remainder(self.yaw[after] - self.yaw[after - 1], math.tau)
        return x, y, self.yaw[after - 1] + share * turn


def path_series(recording: RecordedTopics, topic: str) -> PathSeries:
    """The way that odometry reports.

    Args:
        recording: Has messages of nav_msgs/Odometry.
        topic: Their topic, which is recorded and has messages.
    """
    rows = [
        (time, *_pose(message.pose.pose), message.header.frame_id)
        for time, message in timed(recording, topic)
    ]
    times, x, y, yaw, frames = zip(*rows, strict=True)
    return PathSeries(name=topic, frame=frames[0], times=times, x=x, y=y, yaw=yaw)


def laid_on(path: PathSeries, other: PathSeries) -> PathSeries:
    """A way moved and turned so that it is where another one is when that begins.

    Odometry counts from where a robot started; the world does not.

    Args:
        path: The way to move.
        other: The way that stays.
    """
    x0, y0, yaw0 = path.at(other.times[0])
    turn = other.yaw[0] - yaw0
    cos, sin = math.cos(turn), math.sin(turn)
    ways = [(x - x0, y - y0) for x, y in zip(path.x, path.y, strict=True)]
    return replace(
        path,
        x=tuple(other.x[0] + cos * x - sin * y for x, y in ways),
        y=tuple(other.y[0] + sin * x + cos * y for x, y in ways),
        yaw=tuple(yaw + turn for yaw in path.yaw),
    )


def end_error(path: PathSeries, true: PathSeries) -> float:
    """How far the end of a way is from the true one at that time [m]."""
    x, y, _ = true.at(path.times[-1])
    return math.dist((path.x[-1], path.y[-1]), (x, y))


def path_within(path: PathSeries, others: Iterable[PathSeries]) -> PathSeries:
    """The part of a way in the time of other ways, with the poses around it."""
    spans = [(one.times[0], one.times[-1]) for one in others]
    first = bisect_right(path.times, min(start for start, _ in spans)) - 1
    last = bisect_left(path.times, max(end for _, end in spans))
    part = slice(max(first, 0), max(last, 0) + 1)
    return replace(path, times=path.times[part], x=path.x[part], y=path.y[part], yaw=path.yaw[part])


def _pose(pose: Any) -> tuple[float, float, float]:
    q = pose.orientation
    length = math.hypot(q.x, q.y, q.z, q.w) or 1.0
    turn = (q.x / length, q.y / length, q.z / length, q.w / length)
    return pose.position.x, pose.position.y, roll_pitch_yaw(turn)[2]


_TRUE_COLOR: Final = "#1d2733"
_LONGEST: Final = 30


class PathPlot(Plot):
    """x and y of nav_msgs/Odometry, seen from above.

    Args:
        recording: Of topics of that type.
        topics: Their names; all of that type if None.
        truth: The true way: another recording with one such topic, as `sim.record_model("car")` makes it, or the name of a
            topic of the same recording; None if it is not to be shown.
        align: Whether the true way is moved to begin where odometry does, which counts from there.

    Attributes:
        paths: The ways that odometry gives.
        truth: The true way; None if it is not shown.

    Raises:
        UnknownNameError: A topic was not recorded.
        SimkitError: There is nothing of that type.
    """

    def __init__(
        self,
        recording: RecordedTopics,
        *,
        topics: Sequence[str] | None = None,
        truth: RecordedTopics | str | None = None,
        align: bool = True,
    ) -> None:
        true = _truth(recording, truth)
        found = topics_of(recording, _ODOMETRY) if topics is None else topics
        names = [recorded_topic(recording, _ODOMETRY, name) for name in found]
        if true is not None:
            names = [name for name in names if (truth is not None) and name != true.name]
        if not names:
            names = [recorded_topic(recording, _ODOMETRY, None)]
        self.paths: tuple[PathSeries, ...] = tuple(path_series(recording, n) for n in names)
        if true is not None:
            true = path_within(laid_on(true, self.paths[0]) if align else true, self.paths)
        self.truth: PathSeries | None = true

    @property
    def title(self) -> str:
        """The ways, and how far from the true end they end."""
        names = ", ".join(abbreviated(path.name, _LONGEST) for path in self.paths)
        if self.truth is None:
            return f"way of {names}"
        off = max(end_error(path, self.truth) for path in self.paths)
        return f"way of {names}: ends {off:.3g} m from the true one"

    def figure(self) -> Figure:
        """The ways, as long in x as in y; a ring where each begins, a dot where it ends."""
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.2, 5.6), dpi=140, layout="constrained")
        axes = figure.subplots()
        axes.set_title(self.title, loc="left", fontsize=11, parse_math=False)
        for number, path in enumerate(self.paths):
            _draw(axes, path, line_color(number), abbreviated(path.name, _LONGEST))
        if self.truth is not None:  # its gaps show the other where both are one
            _draw(axes, self.truth, _TRUE_COLOR, "true", dashed=True)
        frame = abbreviated(self.paths[0].frame or "?", _LONGEST)
        axes.set_xlabel(f"x [m] in {frame}", parse_math=False)
        axes.set_ylabel("y [m]")
        axes.set_aspect("equal", adjustable="datalim")
        finish([axes])
        return figure


def _draw(axes: Axes, path: PathSeries, color: str, label: str, *, dashed: bool = False) -> None:
    style = (0, (4, 3)) if dashed else "-"
    axes.plot(path.x, path.y, color=color, linestyle=style, linewidth=1.6, label=label)
    axes.plot(path.x[:1], path.y[:1], "o", color=color, markerfacecolor="white", markersize=6)
    axes.plot(path.x[-1:], path.y[-1:], "o", color=color, markersize=6)


def _truth(recording: RecordedTopics, truth: RecordedTopics | str | None) -> PathSeries | None:
    if truth is None:
        return None
    if isinstance(truth, str):
        return path_series(recording, recorded_topic(recording, _ODOMETRY, truth))
    found = topics_of(truth, _ODOMETRY)
    if len(found) != 1:
        raise SimkitError(
            f"the true way is to have one topic of {_ODOMETRY}, not {', '.join(found) or 'none'}: "
            "let sim.record_model() record it"
        )
    return path_series(truth, found[0])
