"""Ways over the ground as a figure: where odometry says that a robot went, and where it went."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from simkit.errors import SimkitError
from simkit.viz.draw.letters import shortened
from simkit.viz.plots.path_series import TYPE, PathSeries, end_error, laid_on, path_series, within
from simkit.viz.plots.plot import Plot, finish, line_color
from simkit.viz.plots.recorded import recorded_topic, topics_of
from simkit.viz.transform_series import RecordedTopics

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

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
        paths: The ways that were told.
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
        found = topics_of(recording, TYPE) if topics is None else topics
        names = [recorded_topic(recording, TYPE, name) for name in found]
        if true is not None:
            names = [name for name in names if (truth is not None) and name != true.name]
        if not names:
            names = [recorded_topic(recording, TYPE, None)]
        self.paths: tuple[PathSeries, ...] = tuple(path_series(recording, n) for n in names)
        if true is not None:
            true = within(laid_on(true, self.paths[0]) if align else true, self.paths)
        self.truth: PathSeries | None = true

    @property
    def title(self) -> str:
        """The ways, and how far from the true end they end."""
        names = ", ".join(shortened(path.name, _LONGEST) for path in self.paths)
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
            _draw(axes, path, line_color(number), shortened(path.name, _LONGEST))
        if self.truth is not None:  # its gaps show the other where both are one
            _draw(axes, self.truth, _TRUE_COLOR, "true", dashed=True)
        frame = shortened(self.paths[0].frame or "?", _LONGEST)
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
        return path_series(recording, recorded_topic(recording, TYPE, truth))
    found = topics_of(truth, TYPE)
    if len(found) != 1:
        raise SimkitError(
            f"the true way is to have one topic of {TYPE}, not {', '.join(found) or 'none'}: "
            "let sim.record_model() record it"
        )
    return path_series(truth, found[0])
