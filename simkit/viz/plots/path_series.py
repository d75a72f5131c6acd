"""Ways over the ground, as numbers to plot: what nav_msgs/Odometry told, beside the true way."""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, Final

from simkit.geometry import roll_pitch_yaw
from simkit.viz.plots.recorded import timed
from simkit.viz.transform_series import RecordedTopics

TYPE: Final = "nav_msgs/Odometry"
"""Type of the messages."""


@dataclass(frozen=True, slots=True, kw_only=True)
class PathSeries:
    """One way."""

    name: str
    """Its topic."""
    frame: str
    """The frame that it is told in."""
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
    """The way that odometry tells.

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


def within(path: PathSeries, others: Iterable[PathSeries]) -> PathSeries:
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
