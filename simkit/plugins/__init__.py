"""The plugins of gazebo_ros: what makes a robot in a world drive, see, feel and obey.

Read it in this order: `plugin` (what a plugin is), `site` (what it is given), `registry` (what an entry is), `tags` (which there
are, and what their tags may say); then one file, or one package, a plugin. Nothing is loaded before it is used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simkit.plugins.plugin import Plugin
    from simkit.plugins.registry import PluginEntry, plugins
    from simkit.plugins.site import PluginError, Site

_HOMES = {
    "Plugin": "plugin",
    "PluginEntry": "registry",
    "PluginError": "site",
    "Site": "site",
    "plugins": "registry",
}

__all__ = ["Plugin", "PluginEntry", "PluginError", "Site", "plugins"]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
