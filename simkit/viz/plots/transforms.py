"""A transform over time, as numbers and as a figure: position and yaw over virtual seconds."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from simkit.geometry import roll_pitch_yaw
from simkit.msgs import Duration, Time
from simkit.tf import Buffer, BufferCore, TransformException
from simkit.viz.draw.letters import abbreviated
from simkit.viz.plots.plot import Plot, RecordedTopics, finish, panels

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SAMPLES: Final = 801
"""So many values are taken of a transform."""
_FOR_EVER = Duration(10**8)
"A recording is never too long for a buffer of this many seconds."


@dataclass(frozen=True, slots=True, kw_only=True)
class TransformSeries:
    """Where `source` was, seen from `target`, as long as both are known."""

    target: str
    """The frame it is seen from."""
    source: str
    """The frame that is seen."""
    start: Time
    """Time of the first value."""
    seconds: tuple[float, ...]
    """Time of each value since `start` [s]."""
    x: tuple[float, ...]
    """x of its origin [m]."""
    y: tuple[float, ...]
    """y of its origin [m]."""
    z: tuple[float, ...]
    """z of its origin [m]."""
    yaw: tuple[float, ...]
    """Its turn about z, without jumps at pi [rad]."""


def transform_series(
    transforms: Buffer | RecordedTopics, *, target: str, source: str
) -> TransformSeries:
    """The transform between two frames at evenly spaced times.

    Args:
        transforms: A buffer, which reaches 10 s back, or a recording of /tf (and /tf_static).
        target: The frame it is seen from.
        source: The frame that is seen.

    Raises:
        TransformException: There is no way between the frames; `hint` says what to do.
    """
    buffer = transforms if isinstance(transforms, Buffer) else buffer_of(transforms)
    latest = buffer.lookup_transform(target, source).header.stamp
    first, last = _span(buffer.core, target, source, latest.to_nsec())
    steps = SAMPLES - 1 if last > first else 1
    times = sorted({first + (last - first) * step // steps for step in range(steps + 1)})
    rows = []
    for time in times:
        try:
            found = buffer.core.lookup(target, source, time=time)
        except TransformException:
            continue  # a frame changed its parent, and was nowhere in between
        rows.append((time, *found.translation, roll_pitch_yaw(found.rotation)[2]))
    _, x, y, z, yaw = zip(*rows, strict=True)
    return TransformSeries(
        target=target,
        source=source,
        start=Time.from_nsec(rows[0][0]),
        seconds=tuple((row[0] - rows[0][0]) / 1e9 for row in rows),
        x=x,
        y=y,
        z=z,
        yaw=_unwrapped(yaw),
    )


def buffer_of(recording: RecordedTopics) -> Buffer:
    """A buffer that holds everything that was said on /tf and /tf_static in a recording."""
    buffer = Buffer(cache_time=_FOR_EVER)
    recorded = recording.topics()
    for topic, store in (
        ("/tf_static", buffer.set_transform_static),
        ("/tf", buffer.set_transform),
    ):
        for _, message in recording[topic] if topic in recorded else ():
            transforms: Iterable[Any] = message.transforms
            for transform in transforms:
                store(transform, "recording")
    return buffer


def _span(core: BufferCore, target: str, source: str, latest: int) -> tuple[int, int]:
    """First and last time at which the way between two frames is known [ns]."""
    chain = core.chain(target, source, target_time=latest, source_time=latest, fixed=target)
    first = 0
    for frame in chain:
        cache = core.frames.caches[core.frames.number(frame)]
        if cache is not None and core.parent_of(frame) in chain:
            first = max(first, cache.span[0])
    return (first, latest) if first else (0, 0)


def _unwrapped(angles: Iterable[float]) -> tuple[float, ...]:
    found: list[float] = []
    for angle in angles:
        turns = round((found[-1] - angle) / (2 * math.pi)) if found else 0
        found.append(angle + 2 * math.pi * turns)
    return tuple(found)


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
    source, target = (abbreviated(name, _LONGEST) for name in (series.source, series.target))
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
