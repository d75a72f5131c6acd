"""Notices a frame that two nodes broadcast in turn, which makes it jump."""

from __future__ import annotations


class BroadcasterWatch:
    """Remembers who broadcast each frame.

    A node that takes over from another is no fault; two that alternate are, and tf says nothing.
    """

    def __init__(self) -> None:
        self._last: dict[str, str] = {}
        self._parents: dict[str, dict[str, str]] = {}
        self._reported: set[str] = set()

    def note(self, child: str, parent: str, *, authority: str) -> str:
        """Note one broadcast.

        Args:
            child: Frame that was broadcast.
            parent: Its parent in this broadcast.
            authority: The node that sent it.

        Returns:
            A sentence, the first time that a former broadcaster is heard again; else empty.
        """
        parents = self._parents.setdefault(child, {})
        alternates = authority in parents and self._last[child] != authority
        parents[authority] = parent
        self._last[child] = authority
        if not alternates or child in self._reported:
            return ""
        self._reported.add(child)
        who = " and ".join(f"{name} (parent {under})" for name, under in parents.items())
        return (
            f'Frame "{child}" has {len(parents)} broadcasters: {who}. '
            "A frame has one parent and one broadcaster; it jumps between them."
        )
