"""The frames that a buffer has heard of: names, data and broadcasters by number."""

from __future__ import annotations

from typing import Final, TypeAlias

from simkit.geometry import Quaternion, Vector
from simkit.tf.cache import TimeCache
from simkit.tf.static_cache import StaticCache

Cache: TypeAlias = TimeCache | StaticCache

NO_FRAME: Final = 0
"The number of no frame; tf2 shows it by the name NO_PARENT."


class FrameTable:
    """Frames in the order of their first appearance; a root has a name, but no cache.

    Attributes:
        names: Name of each frame, by number.
        caches: Transforms of each frame to its parent, by number; None for a root.
        authorities: Node that last broadcast a frame, by the frame's number.
    """

    __slots__ = ("_cache_time", "_numbers", "authorities", "caches", "names")

    def __init__(self, cache_time: int) -> None:
        self._cache_time = cache_time
        self.names: list[str] = ["NO_PARENT"]
        self.caches: list[Cache | None] = [None]
        self.authorities: dict[int, str] = {}
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
        return cache.insert(stamp, (self._intern(parent), translation, rotation))

    def _intern(self, name: str) -> int:
        number = self._numbers.get(name)
        if number is None:
            number = self._numbers[name] = len(self.names)
            self.names.append(name)
            self.caches.append(None)
        return number
