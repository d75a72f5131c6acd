"""The plugins of gazebo_ros: what makes a robot in a world drive, see, feel and obey.

Read it in this order: `plugin` (what a plugin is), `site` (what it is given), `parameters` (what its
tag says), `registry` (which there are); then one file, or one package, a plugin.
"""

from simkit.plugins.errors import PluginError
from simkit.plugins.plugin import Plugin
from simkit.plugins.registry import PluginEntry, plugins
from simkit.plugins.site import Site

__all__ = ["Plugin", "PluginEntry", "PluginError", "Site", "plugins"]
