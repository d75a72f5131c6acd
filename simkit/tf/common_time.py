"""The time that "latest" means: the newest at which a whole way between two frames has data."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import Final

from simkit.tf.climb import MAX_DEPTH, loop_error
from simkit.tf.errors import ConnectivityException
from simkit.tf.frame_table import FrameTable

_NEVER: Final = sys.maxsize


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
    common = _NEVER
    trail: list[tuple[int, int]] = []
    for stamp, parent in _newest_links(table, source):
        trail.append((stamp, parent))
        common = min(common, stamp or _NEVER)
        if parent == target:
            return 0 if common == _NEVER else common
    return _over_common_parent(table, target, source, trail)


def _over_common_parent(
    table: FrameTable, target: int, source: int, trail: list[tuple[int, int]]
) -> int:
    """The time of a way that climbs from the target until it meets the source's `trail`."""
    on_trail = {parent for _, parent in trail}
    common = _NEVER
    for stamp, parent in _newest_links(table, target):
        common = min(common, stamp or _NEVER)
        if parent in on_trail:
            break
        if parent == source:
            return 0 if common == _NEVER else common
    else:
        raise unconnected(table, target, source)
    for stamp, passed in trail:
        common = min(common, stamp or _NEVER)
        if passed == parent:
            break
    return 0 if common == _NEVER else common


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
