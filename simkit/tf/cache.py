"""The past of one frame: its stamped transforms to its parent, and what lies between them."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from typing import Final, TypeAlias

from simkit.geometry import Quaternion, Vector, slerp

Edge: TypeAlias = tuple[int, Vector, Quaternion]
"""Id of the parent, and the transform that takes coordinates in the frame to the parent's.

A plain tuple, and the parent is part of each sample: a frame may have changed its parent.
"""

LATEST: Final = 0
"As a time: the newest that there is."

OLD_DATA: Final = (
    "TF_OLD_DATA ignoring data from the past "
    "(Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained)"
)
REPEATED_DATA: Final = "TF_REPEATED_DATA ignoring data with redundant timestamp"


def between(older: Edge, newer: Edge, ratio: float) -> Edge:
    """Transform at `ratio` of the way: straight for the origin, on a great circle for the rest.

    A frame that changed its parent in between keeps the older transform: there is no way to
    interpolate across.
    """
    if older[0] != newer[0]:
        return older
    x0, y0, z0 = older[1]
    x1, y1, z1 = newer[1]
    rest = 1.0 - ratio
    return (
        older[0],
        (rest * x0 + ratio * x1, rest * y0 + ratio * y1, rest * z0 + ratio * z1),
        slerp(older[2], newer[2], ratio),
    )


class TimeCache:
    """Transforms of a moving frame over the last `length` nanoseconds of its own stamps.

    Source:
        tf2 `TimeCache`; bounds are inclusive at both ends.
    """

    __slots__ = ("_edges", "_length", "_stamps")

    def __init__(self, length: int) -> None:
        self._length = length
        self._stamps: list[int] = []
        self._edges: list[Edge] = []

    def insert(self, stamp: int, edge: Edge) -> str:
        """Store a transform; samples that are then too old are dropped.

        Returns:
            Why it was refused, in tf's words; empty if it was stored.
        """
        stamps = self._stamps
        if stamps and stamps[-1] > stamp + self._length:
            return OLD_DATA
        place = bisect_left(stamps, stamp)
        if place < len(stamps) and stamps[place] == stamp:
            return REPEATED_DATA
        stamps.insert(place, stamp)
        self._edges.insert(place, edge)
        expired = bisect_left(stamps, stamps[-1] - self._length)
        if expired:
            del stamps[:expired], self._edges[:expired]
        return ""

    def at(self, time: int) -> Edge | None:
        """Transform at `time` [ns], interpolated; the newest for `LATEST`, None if unknown."""
        stamps = self._stamps
        if not stamps:
            return None
        newest = stamps[-1]
        if time == newest or time == LATEST:  # noqa: SIM109 - a tuple to look in takes longer
            return self._edges[-1]
        if time > newest or time < stamps[0]:
            return None
        after = bisect_right(stamps, time)
        older, start = self._edges[after - 1], stamps[after - 1]
        if start == time:
            return older
        return between(older, self._edges[after], (time - start) / (stamps[after] - start))

    def refusal(self, time: int) -> str:
        """Why there is no transform at `time`, in tf's words; empty for an empty cache."""
        if not self._stamps:
            return ""
        oldest, newest = self.span
        text = "Lookup would require extrapolation "
        if len(self) == 1:
            return f"{text}at time {_sec(time)}, but only time {_sec(newest)} is in the buffer"
        if time > newest:
            return (
                f"{text}{_sec(time - newest)}s into the future.  "
                f"Requested time {_sec(time)} but the latest data is at time {_sec(newest)}"
            )
        return (
            f"{text}{_sec(oldest - time)}s into the past.  "
            f"Requested time {_sec(time)} but the earliest data is at time {_sec(oldest)}"
        )

    @property
    def newest_link(self) -> tuple[int, int]:
        """Newest stamp [ns] and the id of the parent at that time; zeros for an empty cache."""
        return (self._stamps[-1], self._edges[-1][0]) if self._stamps else (0, 0)

    @property
    def span(self) -> tuple[int, int]:
        """Oldest and newest stamp [ns]; zeros for an empty cache."""
        return (self._stamps[0], self._stamps[-1]) if self._stamps else (0, 0)

    def __len__(self) -> int:
        return len(self._stamps)

    def clear(self) -> None:
        """Forget every sample."""
        self._stamps.clear()
        self._edges.clear()


def _sec(nanoseconds: int) -> str:
    """Seconds with nine decimals, exact: a float has too few digits for today's date."""
    return f"{nanoseconds // 10**9}.{nanoseconds % 10**9:09d}"
