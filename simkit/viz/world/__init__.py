"""The window of Gazebo: the models of a world, its contacts, what lasers see; still, live and recorded.

Read it in this order: `things` (what is seen of a world), `shapes`, `bodies` and `marks` (what is drawn
of it), `scene` and `source` (all of that at one moment), `view`; then `tape`, `play` and `replay` for recordings.
Nothing here draws: scenes are drawn as those of rviz are.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simkit.viz.world.replay import WorldReplay
    from simkit.viz.world.settings import WorldSettings
    from simkit.viz.world.source import WorldSource
    from simkit.viz.world.tape import WorldTape
    from simkit.viz.world.view import LiveWorld, WorldView

__all__ = [
    "LiveWorld",
    "WorldReplay",
    "WorldSettings",
    "WorldSource",
    "WorldTape",
    "WorldView",
]

_HOMES = {
    "LiveWorld": "view",
    "WorldReplay": "replay",
    "WorldSettings": "settings",
    "WorldSource": "source",
    "WorldTape": "tape",
    "WorldView": "view",
}


def __getattr__(name: str) -> Any:
    # Loaded when first used: who draws nothing loads nothing.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
