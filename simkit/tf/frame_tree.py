"""The frames of a buffer, by number: names, data, broadcasters, and how their tree is climbed."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Final, NamedTuple, TypeAlias

from simkit.geometry import Quaternion, Vector
from simkit.tf.cache import StaticCache, TimeCache
from simkit.tf.errors import ConnectivityException, LookupException

if TYPE_CHECKING:
    from simkit.tf.path import Path

Cache: TypeAlias = TimeCache | StaticCache

NO_FRAME: Final = 0
"The number of no frame; tf2 shows it by the name NO_PARENT."

MAX_DEPTH: Final = 1000
"Longest way to a root; a longer one is taken for a loop."

NEVER: Final = sys.maxsize
"Later than any stamp."


class FrameTable:
    """Frames in the order of their first appearance; a root has a name, but no cache.

    Attributes:
        names: Name of each frame, by number.
        caches: Transforms of each frame to its parent, by number; None for a root.
        authorities: Node that last broadcast a frame, by the frame's number.
        changes: Number of transforms that were taken in, or forgotten at once.
        paths: The ways that were asked for since the shape of the tree changed, by the numbers of
            target and source; None for a way that changes with time.
    """

    __slots__ = ("_cache_time", "_numbers", "authorities", "caches", "changes", "names", "paths")

    def __init__(self, cache_time: int) -> None:
        self._cache_time = cache_time
        self.names: list[str] = ["NO_PARENT"]
        self.caches: list[Cache | None] = [None]
        self.authorities: dict[int, str] = {}
        self.changes = 0
        self.paths: dict[tuple[int, int], Path | None] = {}
        self._numbers = {"NO_PARENT": NO_FRAME}

    def number(self, name: str) -> int:
        """Number of a frame; `NO_FRAME` if the name is unknown."""
        return self._numbers.get(name, NO_FRAME)

    def __contains__(self, name: object) -> bool:
        return name in self._numbers

    @property
    def known_names(self) -> list[str]:
        """Every frame, roots included, in the order of appearance."""
        return self.names[1:]

    def insert(
        self,
        child: str,
        parent: str,
        *,
        stamp: int,
        translation: Vector,
        rotation: Quaternion,
        static: bool,
    ) -> str:
        """Store a transform of `child`, whose first transform decides for ever if it is static.

        Returns:
            Why it was refused, in tf's words; empty if it was stored.
        """
        number = self._intern(child)
        cache = self.caches[number]
        if cache is None:
            cache = StaticCache() if static else TimeCache(self._cache_time)
            self.caches[number] = cache
        self.changes += 1
        before = cache.parent
        refusal = cache.insert(stamp, (self._intern(parent), translation, rotation))
        # A path holds the product of its static parts.
        if cache.parent != before or isinstance(cache, StaticCache):
            self.paths.clear()
        return refusal

    def clear(self) -> None:
        """Forget the transforms of moving frames; names and static transforms stay."""
        for cache in self.caches:
            if cache is not None:
                cache.clear()
        self.changes += 1
        self.paths.clear()

    def _intern(self, name: str) -> int:
        number = self._numbers.get(name)
        if number is None:
            number = self._numbers[name] = len(self.names)
            self.names.append(name)
            self.caches.append(None)
        return number


def as_lines(table: FrameTable) -> str:
    """One line per frame that ever had a parent.

    Source:
        tf2 `BufferCore::allFramesAsString`.
    """
    return "".join(
        f"Frame {table.names[number]} exists with parent {table.names[cache.newest_link[1]]}.\n"
        for number, cache in enumerate(table.caches)
        if cache is not None and number != NO_FRAME
    )


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
        "The tf tree is invalid because it contains a loop.\n" + as_lines(table) + "\n"
    )
