"""The tree, climbed link by link, and the newest time that a whole way knows."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Final, NamedTuple

from simkit.tf import frame_report
from simkit.tf.errors import ConnectivityException, LookupException
from simkit.tf.frame_table import Cache, FrameTable

MAX_DEPTH: Final = 1000
"Longest way to a root; a longer one is taken for a loop."

NEVER: Final = sys.maxsize
"Later than any stamp."


class Climb(NamedTuple):
    """How far a climb came, and what it passed."""

    top: int
    "Number of the frame where it ended."
    lacks_data: bool
    "Whether it ended because `top` has no transform at the time."
    links: list[Cache]
    "The links that it passed, the lowest first."


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
    frame = start
    links: list[Cache] = []
    for _ in range(MAX_DEPTH + 1):
        cache = table.caches[frame]
        if frame in goals or cache is None:
            return Climb(frame, False, links)
        edge = cache.at(time)
        if edge is None or not edge[0]:
            return Climb(frame, True, links)
        links.append(cache)
        frame = edge[0]
    raise loop_error(table)


def latest_common_time(table: FrameTable, target: int, source: int) -> int:
    """Least of the newest stamps on the way between two frames [ns]; 0 if all are static.

    Only the newest transform of each frame counts, so a frame that began later can still lack
    data at the time that is found.

    Raises:
        ConnectivityException: No way joins the frames.
        LookupException: The tree has a loop on the way.

    Source:
        tf2 `BufferCore::getLatestCommonTime`.
    """
    if target == source:
        cache = table.caches[source]
        return cache.newest_link[0] if cache else 0
    common = NEVER
    trail: list[tuple[int, int]] = []
    for stamp, parent in _newest_links(table, source):
        trail.append((stamp, parent))
        common = min(common, stamp or NEVER)
        if parent == target:
            return 0 if common == NEVER else common
    return _over_common_parent(table, target, source, trail)


def _over_common_parent(
    table: FrameTable, target: int, source: int, trail: list[tuple[int, int]]
) -> int:
    """The time of a way that climbs from the target until it meets the source's `trail`."""
    on_trail = {parent for _, parent in trail}
    common = NEVER
    for stamp, parent in _newest_links(table, target):
        common = min(common, stamp or NEVER)
        if parent in on_trail:
            break
        if parent == source:
            return 0 if common == NEVER else common
    else:
        raise unconnected(table, target, source)
    for stamp, passed in trail:
        common = min(common, stamp or NEVER)
        if passed == parent:
            break
    return 0 if common == NEVER else common


def _newest_links(table: FrameTable, frame: int) -> Iterator[tuple[int, int]]:
    """Newest stamp and parent of `frame`, of its parent, and so on to the root."""
    for _ in range(MAX_DEPTH + 1):
        cache = table.caches[frame]
        if not cache:
            return
        link = cache.newest_link
        frame = link[1]
        if not frame:
            return
        yield link
    raise loop_error(table)


def unconnected(table: FrameTable, target: int, source: int) -> ConnectivityException:
    """The error for frames in two trees, in tf's words."""
    return ConnectivityException(
        f"Could not find a connection between '{table.names[target]}' and "
        f"'{table.names[source]}' because they are not part of the same tree."
        "Tf has two or more unconnected trees.",
        frames=(table.names[target], table.names[source]),
    )


def loop_error(table: FrameTable) -> LookupException:
    """The error for a way that never ends, in tf's words."""
    return LookupException(
        "The tf tree is invalid because it contains a loop.\n" + frame_report.as_lines(table) + "\n"
    )
