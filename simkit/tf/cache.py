"""What is known of one frame: its stamped transforms to its parent, and what lies between them."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from math import acos, sin, sqrt  # by name: they are in the path of every lookup
from operator import mul
from typing import Final, TypeAlias

from simkit.geometry import Quaternion, Transform, Vector

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

Arc: TypeAlias = tuple[float, ...]
"""The way from one sample to the next, computed once, as it is walked again and again.

Its start [ns], its length [ns], the origin (3) and rotation (4) of the older sample, the same of
the newer one, the angle between the rotations [rad], the sine of it, and that sine again, negative
for a quaternion in the other hemisphere. The three are 0 where there is nothing to turn.
"""


def carried(links: Iterable[TimeCache | StaticCache], time: int) -> Transform | None:
    """T_ab at a time, of the links from b (the lowest) up to a; None if one has no data then.

    Between two samples the origin goes straight and the rotation on a great circle. This is where
    a lookup spends its time, so `geometry.slerp` and `Transform.__matmul__` are written out here.
    """
    x = y = z = qx = qy = qz = 0.0
    qw = 1.0
    for link in links:
        arc = link.arcs[bisect_right(link.stamps, time)]
        if arc is None:
            edge = link.at(time)
            if edge is None:
                return None
            _, (dx, dy, dz), (ex, ey, ez, ew) = edge
        else:
            (
                start,
                length,
                x0,
                y0,
                z0,
                ex,
                ey,
                ez,
                ew,
                x1,
                y1,
                z1,
                fx,
                fy,
                fz,
                fw,
                angle,
                sine,
                signed,
            ) = arc
            ratio = (time - start) / length
            rest = 1.0 - ratio
            dx, dy, dz = rest * x0 + ratio * x1, rest * y0 + ratio * y1, rest * z0 + ratio * z1
            if angle:
                a, b = sin(rest * angle) / sine, sin(ratio * angle) / signed
                ex, ey, ez, ew = a * ex + b * fx, a * ey + b * fy, a * ez + b * fz, a * ew + b * fw
        tx, ty, tz = 2.0 * (ey * z - ez * y), 2.0 * (ez * x - ex * z), 2.0 * (ex * y - ey * x)
        scale = ex * ex + ey * ey + ez * ez + ew * ew
        x, y, z = (
            dx + scale * x + ew * tx + ey * tz - ez * ty,
            dy + scale * y + ew * ty + ez * tx - ex * tz,
            dz + scale * z + ew * tz + ex * ty - ey * tx,
        )
        qx, qy, qz, qw = (
            ew * qx + ex * qw + ey * qz - ez * qy,
            ew * qy - ex * qz + ey * qw + ez * qx,
            ew * qz + ex * qy - ey * qx + ez * qw,
            ew * qw - ex * qx - ey * qy - ez * qz,
        )
    return Transform((x, y, z), (qx, qy, qz, qw))


def arc_between(older: Edge, newer: Edge, *, start: int, end: int) -> Arc:
    """The way between two samples with one parent, from `start` to `end` [ns].

    Source:
        tf2 `Quaternion::slerp`, as `geometry.slerp`: the angle comes from the arc cosine of the
        normalised product.
    """
    _, origin, q0 = older
    _, goal, q1 = newer
    dot, square0, square1 = (sum(map(mul, a, b)) for a, b in ((q0, q1), (q0, q0), (q1, q1)))
    cosine = abs(dot) / sqrt(square0 * square1)
    angle = acos(cosine) if cosine < 1.0 else 0.0
    sine = sin(angle)
    signed = sine if dot >= 0.0 else -sine
    return (start, end - start, *origin, *q0, *goal, *q1, angle, sine, signed)


class TimeCache:
    """Transforms of a moving frame over the last `length` nanoseconds of its own stamps.

    Attributes:
        stamps: Times of the samples [ns], ascending.
        arcs: The ways between the samples as far as they were asked for; `arcs[i]` ends at
            `stamps[i]`, and the first and the last one, outside of the samples, are None.
        newest: Newest stamp [ns]; 0 for an empty cache.
        parent: Number of the parent in all samples; 0 if there are several parents, or no samples.

    Source:
        tf2 `TimeCache`; bounds are inclusive at both ends.
    """

    __slots__ = ("_edges", "_length", "arcs", "newest", "parent", "stamps")

    def __init__(self, length: int) -> None:
        self._length = length
        self._edges: list[Edge] = []
        self.stamps: list[int] = []
        self.arcs: list[Arc | None] = [None]
        self.newest = 0
        self.parent = 0

    def insert(self, stamp: int, edge: Edge) -> str:
        """Store a transform; samples that are then too old are dropped.

        Returns:
            Why it was refused, in tf's words; empty if it was stored.
        """
        stamps = self.stamps
        if stamps and self.newest > stamp + self._length:
            return OLD_DATA
        place = bisect_left(stamps, stamp)
        if place < len(stamps) and stamps[place] == stamp:
            return REPEATED_DATA
        if not stamps:
            self.parent = edge[0]
        elif edge[0] != self.parent:
            self.parent = 0
        stamps.insert(place, stamp)
        self._edges.insert(place, edge)
        self.arcs[place] = None
        self.arcs.insert(place, None)
        self.newest = stamps[-1]
        if stamps[0] < self.newest - self._length:
            self._drop_expired()
        return ""

    def _drop_expired(self) -> None:
        expired = bisect_left(self.stamps, self.newest - self._length)
        del self.stamps[:expired], self._edges[:expired], self.arcs[:expired]
        self.arcs[0] = None
        if not self.parent and len({edge[0] for edge in self._edges}) == 1:
            self.parent = self._edges[0][0]

    def at(self, time: int) -> Edge | None:
        """Transform at `time` [ns], interpolated; the newest for `LATEST`, None if unknown."""
        stamps = self.stamps
        if not stamps:
            return None
        if time == self.newest or time == LATEST:
            return self._edges[-1]
        if time > self.newest or time < stamps[0]:
            return None
        place = bisect_right(stamps, time)
        start = stamps[place - 1]
        older, newer = self._edges[place - 1], self._edges[place]
        if start == time or older[0] != newer[0]:
            return older  # there is no way to interpolate across a change of parent
        if self.arcs[place] is None:
            self.arcs[place] = arc_between(older, newer, start=start, end=stamps[place])
        found = carried((self,), time)
        return found and (older[0], *found)

    def refusal(self, time: int) -> str:
        """Why there is no transform at `time`, in tf's words; empty for an empty cache."""
        if not self.stamps:
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
        return (self.newest, self._edges[-1][0]) if self.stamps else (0, 0)

    @property
    def span(self) -> tuple[int, int]:
        """Oldest and newest stamp [ns]; zeros for an empty cache."""
        return (self.stamps[0], self.stamps[-1]) if self.stamps else (0, 0)

    def __len__(self) -> int:
        return len(self.stamps)

    def clear(self) -> None:
        """Forget every sample."""
        del self.stamps[:], self._edges[:], self.arcs[1:]
        self.newest = self.parent = 0


class StaticCache:
    """The one transform of a static frame; the last that was given.

    It reports stamp 0, which a search for the latest common time passes over.

    Attributes:
        parent: Number of its parent; 0 before the first transform.
        stamps: None, as in an empty TimeCache.
        arcs: None either.

    Source:
        tf2 `StaticCache`.
    """

    __slots__ = ("_edge", "parent")
    stamps: tuple[int, ...] = ()
    arcs: tuple[Arc | None, ...] = (None,)

    def __init__(self, edge: Edge | None = None) -> None:
        self._edge = edge
        self.parent = edge[0] if edge else 0

    def insert(self, stamp: int, edge: Edge) -> str:  # noqa: ARG002 - the form of TimeCache
        """Replace the transform; never refused."""
        self._edge = edge
        self.parent = edge[0]
        return ""

    def at(self, time: int) -> Edge | None:  # noqa: ARG002 - the same at any time
        """The transform."""
        return self._edge

    def refusal(self, time: int) -> str:  # noqa: ARG002 - never asked with data
        """Empty: a static transform has no limits of time."""
        return ""

    @property
    def newest_link(self) -> tuple[int, int]:
        """Stamp 0, and the id of the parent."""
        return (0, self.parent)

    @property
    def span(self) -> tuple[int, int]:
        """Zeros: the transform has no stamps."""
        return (0, 0)

    def __len__(self) -> int:
        return 1 if self._edge else 0

    def clear(self) -> None:
        """Nothing: static transforms outlive a jump of the clock."""


def _sec(nanoseconds: int) -> str:
    """Seconds with nine decimals, exact: a float has too few digits for today's date."""
    return f"{nanoseconds // 10**9}.{nanoseconds % 10**9:09d}"
