"""The error of spawning."""

from __future__ import annotations

from simkit.errors import SimkitError


class SpawnError(SimkitError):
    """A model that does not come into the world: why, and what would be right.

    Args:
        status: What Gazebo's service says of it.
        more: What else there is to say.
    """

    def __init__(self, status: str, more: str = "") -> None:
        super().__init__(f"{status} {more}".strip())
        self.status = status
        self.more = more
