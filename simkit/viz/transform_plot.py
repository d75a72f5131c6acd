"""A transform over time as a figure: position and yaw over virtual seconds."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from simkit.errors import UnknownNameError
from simkit.tf import Buffer
from simkit.viz.letters import shortened
from simkit.viz.transform_series import RecordedTopics, TransformSeries, transform_series

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FORMATS = (".pdf", ".png", ".svg")
"""What `TransformPlot.save` writes, by suffix."""
_COLORS = {"x": "#d92d2d", "y": "#21913c", "z": "#2b6fe0", "yaw": "#7a4fb5"}
# Where two lines are one, the gaps of the upper show the lower; and red and green look alike to some.
_STYLES = {"x": "-", "y": (0, (7, 3)), "z": (0, (2, 2)), "yaw": "-"}
_LEAST_HEIGHT = 0.02
"Least range of an axis [m, rad]."
_LONGEST = 40


class TransformPlot:
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

    def to_svg(self) -> str:
        """The figure as an SVG document; equal data give equal text."""
        from simkit.viz.plain_matplotlib import plain_settings, svg_of

        with plain_settings():
            return svg_of(_figure(self.series), title=_title(self.series))

    def to_png(self) -> bytes:
        """The figure as a PNG file."""
        from simkit.viz.plain_matplotlib import plain_settings, png_of

        with plain_settings():
            return png_of(_figure(self.series), title=_title(self.series))

    def to_pdf(self) -> bytes:
        """The figure as a PDF file of one page."""
        from simkit.viz.plain_matplotlib import pdf_of, plain_settings

        with plain_settings():
            return pdf_of(_figure(self.series), title=_title(self.series))

    def save(self, path: str | Path) -> None:
        """Write a file: `.svg`, `.png` or `.pdf` by its suffix.

        Raises:
            UnknownNameError: The suffix is another one.
        """
        path = Path(path)
        match path.suffix.lower():
            case ".svg":
                path.write_text(self.to_svg(), encoding="utf-8", newline="\n")
            case ".png":
                path.write_bytes(self.to_png())
            case ".pdf":
                path.write_bytes(self.to_pdf())
            case suffix:
                raise UnknownNameError("picture format", suffix, FORMATS)

    def __repr__(self) -> str:
        return f"TransformPlot({_title(self.series)!r})"

    def _repr_svg_(self) -> str:
        return self.to_svg()


def _title(series: TransformSeries) -> str:
    source, target = (shortened(name, _LONGEST) for name in (series.source, series.target))
    return f'"{source}" seen from "{target}"'


def _figure(series: TransformSeries) -> Figure:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.2, 4.6), dpi=140, layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    above.set_title(_title(series), loc="left", fontsize=11, parse_math=False)
    for name, values in (("x", series.x), ("y", series.y), ("z", series.z)):
        _draw(above, series.seconds, values, name)
    above.set_ylabel("position [m]")
    _draw(below, series.seconds, series.yaw, "yaw")
    below.set_ylabel("yaw [rad]")
    below.set_xlabel(_time_label(series))
    for axes in (above, below):
        _keep_height(axes)
        axes.grid(color="#e3e8ee", linewidth=0.8)
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False)
        axes.ticklabel_format(useOffset=False)
    return figure


def _draw(axes: Axes, seconds: tuple[float, ...], values: tuple[float, ...], name: str) -> None:
    if len(values) == 1:
        seconds, values = (0.0, 1.0), values * 2
    axes.plot(seconds, values, color=_COLORS[name], linestyle=_STYLES[name], label=name)


def _keep_height(axes: Axes) -> None:
    """No scale so fine that it shows rounding errors as motion."""
    low, high = axes.get_ylim()
    spare = (_LEAST_HEIGHT - (high - low)) / 2
    if spare > 0.0:
        axes.set_ylim(low - spare, high + spare)


def _time_label(series: TransformSeries) -> str:
    if not series.start:
        return "virtual time [s]; a static transform, the same at every time"
    return f"virtual time [s] since {series.start.to_sec():.3f}"
