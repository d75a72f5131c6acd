"""Whether a program has a world; without loading the code of worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from simkit.gazebo.server import Gazebo


def gazebo_of(program: object) -> Gazebo | None:
    """The world of a program, if it is a gzserver."""
    found: Gazebo | None = getattr(program, "gazebo", None)
    return found
