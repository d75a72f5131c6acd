"""The way from a frame towards the root, and the transform that adds up on it."""

from __future__ import annotations

from typing import Final, NamedTuple

from simkit.geometry import Quaternion, Vector
from simkit.tf import frame_report
from simkit.tf.errors import LookupException
from simkit.tf.frame_table import FrameTable

MAX_DEPTH: Final = 1000
"Longest way to a root; a longer one is taken for a loop."


class Climb(NamedTuple):
    """How far a climb came, and the transform from its start to there."""

    top: int
    "Number of the frame where it ended."
    lacks_data: bool
    "Whether it ended because `top` has no transform at the time."
    translation: Vector
    "Origin of the start seen from the top [m]."
    rotation: Quaternion
    "Orientation of the start seen from the top, xyzw."


def climb(table: FrameTable, start: int, *, time: int, goals: tuple[int, int]) -> Climb:
    """Climb from `start` to the first of `goals`, a root, or a frame without data at `time`.

    Args:
        table: The frames.
        start: Number of the frame to start from.
        time: Time of the transforms on the way [ns].
        goals: Numbers of two frames, either of which ends the climb.

    Raises:
        LookupException: The tree has a loop on the way.
    """
    caches = table.caches
    frame = start
    x = y = z = qx = qy = qz = 0.0
    qw = 1.0
    for _ in range(MAX_DEPTH + 1):
        if frame in goals:
            return Climb(frame, False, (x, y, z), (qx, qy, qz, qw))
        cache = caches[frame]
        if cache is None:
            return Climb(frame, False, (x, y, z), (qx, qy, qz, qw))
        edge = cache.at(time)
        if edge is None or not edge[0]:
            return Climb(frame, True, (x, y, z), (qx, qy, qz, qw))
        # This is `Transform.__matmul__`, written out: it is where a lookup spends its time.
        frame, (dx, dy, dz), (ex, ey, ez, ew) = edge
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
    raise loop_error(table)


def loop_error(table: FrameTable) -> LookupException:
    """The error for a way that never ends, in tf's words."""
    return LookupException(
        "The tf tree is invalid because it contains a loop.\n" + frame_report.as_lines(table) + "\n"
    )
