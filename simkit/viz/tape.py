"""A scene over time: where each frame was and what each display showed, of any source."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any, Final

from simkit.tf import Buffer
from simkit.viz.stage.marks import Marks, moment_data
from simkit.viz.stage.rviz_settings import OdometryDisplay, TopicDisplay
from simkit.viz.stage.topic_listener import DisplayListener
from simkit.viz.stage.topic_marks import NOTHING, Shown, display_marks

MOST_POINTS: Final = 200_000
"""A replay holds no more points of one display; of a longer recording it shows fewer moments."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TopicTrack:
    """What one display showed over time."""

    marks: Marks
    """What it showed at the end."""
    moments: tuple[tuple[float, Shown], ...]
    """What it showed from a time [s] on; of a trail, the lines that came at that time."""
    keep: int
    """So many lines of a trail are seen, the newest; 0 if it is none."""


class TopicTape:
    """Follows some displays through a recording.

    Args:
        displays: What is shown.
        buffer: The transforms, which grow meanwhile.
        fixed_frame: The frame that everything is drawn in.
    """

    def __init__(
        self, displays: Sequence[TopicDisplay], *, buffer: Buffer, fixed_frame: str
    ) -> None:
        self._displays = displays
        self._listeners = [
            DisplayListener(one, buffer=buffer, fixed_frame=fixed_frame) for one in displays
        ]
        self._moments: list[list[tuple[float, Shown]]] = [[] for _ in displays]
        self._last = [NOTHING] * len(displays)

    @property
    def topics(self) -> list[str]:
        """The topics that it wants to hear, sorted."""
        return sorted({display.topic for display in self._displays})

    def hear(self, topic: str, message: Any) -> None:
        """Take a message."""
        for display, listener in zip(self._displays, self._listeners, strict=True):
            if display.topic == topic:
                listener.hear(message)

    def look(self, time: float) -> None:
        """Keep what is to be seen at a time [s]."""
        for number, listener in enumerate(self._listeners):
            shown, last = listener.look(), self._last[number]
            if shown is not last:
                self._moments[number].append((time, _news(shown, last)))
                self._last[number] = shown

    def troubles(self) -> tuple[str, ...]:
        """What could not be shown at the end."""
        return tuple(trouble for listener in self._listeners if (trouble := listener.trouble()))

    def tracks(self) -> tuple[TopicTrack, ...]:
        """What was kept."""
        return tuple(
            TopicTrack(
                marks=display_marks(display, number, self._last[number]),
                moments=tuple(_thinned(self._moments[number])),
                keep=display.keep if isinstance(display, OdometryDisplay) else 0,
            )
            for number, display in enumerate(self._displays)
        )


def track_data(track: TopicTrack) -> dict[str, Any]:
    """A track for the script of a replay."""
    return {
        "keep": track.keep,
        "moments": [
            {"time": round(time, 3), **moment_data(_marks(track, shown))}
            for time, shown in track.moments
        ],
    }


def _marks(track: TopicTrack, shown: Shown) -> Marks:
    marks = track.marks
    return Marks(
        name=marks.name,
        label=marks.label,
        color=marks.color,
        points=shown.points,
        colors=shown.colors,
        lines=shown.lines,
        is_many_colored=marks.is_many_colored,
    )


def _news(shown: Shown, last: Shown) -> Shown:
    """Of a trail the lines that are new, of anything else all of it."""
    if not shown.count:
        return shown
    return Shown(lines=shown.lines[-(shown.count - last.count) :], count=shown.count)


def _thinned(moments: Sequence[tuple[float, Shown]]) -> Iterable[tuple[float, Shown]]:
    """Every second moment, or every third and so on, if there are too many points; and the last."""
    total = sum(len(shown.points) + sum(map(len, shown.lines)) for _, shown in moments)
    step = 1 + total // MOST_POINTS
    is_trail = any(shown.count for _, shown in moments)
    if step == 1 or is_trail:
        return moments
    return [*moments[:-1:step], moments[-1]]
