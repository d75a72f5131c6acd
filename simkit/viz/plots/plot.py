"""What all plots have in common: what they need of a recording, their files, and how they look."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, Protocol

from simkit.errors import SimkitError, UnknownNameError
from simkit.msgs import Message, Time
from simkit.viz.draw.files import save_as

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LINE_COLORS: Final = (
    *("#2b6fe0", "#d92d2d", "#21913c", "#7a4fb5", "#b7791f"),
    *("#0f8a8a", "#c2418f", "#5b6b7d", "#7a5230", "#1d2733"),
)
"""Of lines beside each other; after the last comes the first again."""
LEAST_HEIGHT: Final = 0.02
"""Least range of an axis: no scale so fine that it shows rounding errors as motion."""


class Plot:
    """A figure, made once; it shows itself in a notebook and is saved as `.svg`, `.png` or `.pdf`."""

    @property
    def title(self) -> str:
        """One line on what it shows."""
        raise NotImplementedError

    def figure(self) -> Figure:
        """The figure; made within the plain settings of matplotlib."""
        raise NotImplementedError

    def to_svg(self) -> str:
        """The figure as an SVG document; equal data give equal text."""
        from simkit.viz.draw.figure import plain_settings, svg_of

        with plain_settings():
            return svg_of(self.figure(), title=self.title)

    def to_png(self) -> bytes:
        """The figure as a PNG file."""
        from simkit.viz.draw.figure import plain_settings, png_of

        with plain_settings():
            return png_of(self.figure(), title=self.title)

    def to_pdf(self) -> bytes:
        """The figure as a PDF file of one page."""
        from simkit.viz.draw.figure import pdf_of, plain_settings

        with plain_settings():
            return pdf_of(self.figure(), title=self.title)

    def save(self, path: str | Path) -> None:
        """Write a file: `.svg`, `.png` or `.pdf` by its suffix.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        save_as(path, {".pdf": self.to_pdf, ".png": self.to_png, ".svg": self.to_svg})

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.title!r})"

    def _repr_svg_(self) -> str:
        return self.to_svg()


def panels(title: str, heights: Sequence[float]) -> tuple[Figure, list[Axes]]:
    """A figure of axes above each other, which share their time.

    Args:
        title: What stands above.
        heights: Share of each in the height.
    """
    from matplotlib.figure import Figure

    height = 1.2 + 1.7 * len(heights)
    figure = Figure(figsize=(7.2, height), dpi=140, layout="constrained")
    grid = figure.subplots(len(heights), 1, sharex=True, squeeze=False, height_ratios=heights)
    axes = [row[0] for row in grid]
    axes[0].set_title(title, loc="left", fontsize=11, parse_math=False)
    return figure, axes


def finish(axes: Iterable[Axes]) -> None:
    """Grid, legend and a height that shows no rounding errors."""
    for one in axes:
        low, high = one.get_ylim()
        spare = (LEAST_HEIGHT - (high - low)) / 2
        if spare > 0.0:
            one.set_ylim(low - spare, high + spare)
        one.grid(color="#e3e8ee", linewidth=0.8)
        one.spines[["top", "right"]].set_visible(False)
        one.ticklabel_format(useOffset=False)
        if one.get_legend_handles_labels()[0]:
            one.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)


def line_color(number: int) -> str:
    """The colour of a line by its number."""
    return LINE_COLORS[number % len(LINE_COLORS)]


class RecordedTopics(Protocol):
    """What `sim.record(["/tf"])` answers."""

    def topics(self) -> list[str]:
        """Names of the recorded topics."""
        ...

    def __getitem__(self, topic: str) -> Iterable[tuple[Time, Message]]:
        """Messages of a topic with their times."""
        ...


def recorded_topic(recording: RecordedTopics, type_name: str, topic: str | None) -> str:
    """The topic to plot.

    Args:
        recording: What was recorded.
        type_name: Type that its messages must have.
        topic: Its name, with or without the slash; the only one of that type if None.

    Raises:
        UnknownNameError: The topic was not recorded.
        SimkitError: It has no message, or messages of another type; or there is not just one of that type.
    """
    if topic is None:
        return _only(recording, type_name)
    name = f"/{topic.lstrip('/')}"
    if name not in recording.topics():
        raise UnknownNameError("recorded topic", name, recording.topics())
    found = _type_of(recording, name)
    if found is None:
        raise SimkitError(
            f"no message on {name} was recorded: record it before the simulation runs"
        )
    if found != type_name:
        raise SimkitError(f"{name} carries {found}, and this plot shows {type_name}")
    return name


def topics_of(recording: RecordedTopics, type_name: str) -> list[str]:
    """Recorded topics that have messages of a type, sorted."""
    return [name for name in recording.topics() if _type_of(recording, name) == type_name]


def timed(recording: RecordedTopics, topic: str) -> Iterator[tuple[int, Any]]:
    """Messages with the time of their header [ns], or if that is 0, that of their arrival."""
    for time, message in recording[topic]:
        stamp: Time = message.header.stamp
        yield (stamp.to_nsec() or time.to_nsec()), message


def _only(recording: RecordedTopics, type_name: str) -> str:
    found = topics_of(recording, type_name)
    if len(found) == 1:
        return found[0]
    if found:
        raise SimkitError(f"{', '.join(found)} were recorded: say which, e.g. topic={found[0]!r}")
    raise SimkitError(
        f"no message of {type_name} was recorded, but {', '.join(recording.topics()) or 'nothing'}: "
        "record its topic before the simulation runs"
    )


def _type_of(recording: RecordedTopics, name: str) -> str | None:
    return next((message._type for _, message in recording[name]), None)
