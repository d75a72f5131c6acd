"""The error of plugins."""

from __future__ import annotations

from simkit.errors import SimkitError


class PluginError(SimkitError):
    """A plugin cannot work as its tag says; it is not loaded, and its model is there without it."""
