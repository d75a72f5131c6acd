"""The frames that a buffer has heard of: names, data and broadcasters by number."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final, TypeAlias

from simkit.geometry import Quaternion, Vector
from simkit.tf.cache import StaticCache, TimeCache

if TYPE_CHECKING:
    from simkit.tf.path import Path

Cache: TypeAlias = TimeCache | StaticCache

NO_FRAME: Final = 0
"The number of no frame; tf2 shows it by the name NO_PARENT."


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
