"""Objects of one's own in a view, by the interface of meshcat: commands that the page hands to meshcat's viewer."""

from __future__ import annotations

import base64
from collections.abc import Callable
from typing import Any


class MeshcatWindow:
    """What `meshcat.Visualizer(window=...)` sends its commands to; it needs no server.

    Of commands that set the same thing the last one is kept, so that a page that is made later has
    all that is there.

    Args:
        changed: Called after each command.
    """

    def __init__(self, changed: Callable[[], None] = lambda: None) -> None:
        self._changed = changed
        self._packed: dict[tuple[str, str, str], str] = {}

    @property
    def commands(self) -> tuple[str, ...]:
        """The commands as meshcat packs them, in base64."""
        return tuple(self._packed.values())

    def send(self, command: Any) -> None:
        """Take a command of meshcat, e.g. a `SetObject`."""
        import umsgpack

        lowered = command.lower()
        path = str(lowered.get("path", ""))
        if lowered["type"] == "delete":
            # The page has to forget it as well, so the command itself is kept.
            self._packed = {
                key: data for key, data in self._packed.items() if not _is_below(key[1], path)
            }
        key = (lowered["type"], path, str(lowered.get("property", "")))
        self._packed.pop(key, None)
        self._packed[key] = base64.b64encode(umsgpack.packb(lowered)).decode("ascii")
        self._changed()


def _is_below(path: str, folder: str) -> bool:
    return path == folder or path.startswith(f"{folder}/")


def visualizer(window: MeshcatWindow) -> Any:
    """A `meshcat.Visualizer` whose objects are seen in the view that has the window."""
    import meshcat

    return meshcat.Visualizer(window=window)
