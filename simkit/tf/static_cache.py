"""A frame that never moves: one transform, valid at every time."""

from __future__ import annotations

from simkit.tf.cache import Edge


class StaticCache:
    """The one transform of a static frame; the last that was given.

    It reports stamp 0, which a search for the latest common time passes over.

    Source:
        tf2 `StaticCache`.
    """

    __slots__ = ("_edge",)

    def __init__(self) -> None:
        self._edge: Edge | None = None

    def insert(self, stamp: int, edge: Edge) -> str:  # noqa: ARG002 - the form of TimeCache
        """Replace the transform; never refused."""
        self._edge = edge
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
        return (0, self._edge[0]) if self._edge else (0, 0)

    @property
    def span(self) -> tuple[int, int]:
        """Zeros: the transform has no stamps."""
        return (0, 0)

    def __len__(self) -> int:
        return 1 if self._edge else 0

    def clear(self) -> None:
        """Nothing: static transforms outlive a jump of the clock."""
