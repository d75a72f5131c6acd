"""What several plugins read from the texts of their tags."""

from __future__ import annotations

import math

from simkit.geometry import Quaternion, Vector, canonical, quaternion_from_rpy
from simkit.plugins.errors import PluginError
from simkit.plugins.naming import topic_of
from simkit.plugins.parameters import place
from simkit.plugins.site import Site


def read_triple(site: Site, name: str, text: str) -> Vector:
    """The three numbers in a tag of the plugin.

    Raises:
        PluginError: There are not three, or one is no number.
    """
    try:
        x, y, z = (float(word) for word in text.split())
    except ValueError:
        x = y = z = math.nan
    if not all(math.isfinite(value) for value in (x, y, z)):
        where = place(site.element.child(name) or site.element, site)
        raise PluginError(f"{where}: <{name}> is three numbers, as in 0 0 0.1, not {text!r}")
    return (x, y, z)


def read_turn(site: Site, name: str, text: str) -> Quaternion:
    """The rotation that a tag of the plugin gives as roll, pitch, yaw [rad]: xyzw; see `read_triple`."""
    return canonical(quaternion_from_rpy(read_triple(site, name, text)))


def topic_at_root(site: Site, tag: str, name: str) -> str:
    """The global name of a topic or service of a plugin whose namespace is empty if nobody gives one.

    That is what the plugins of IMU and bumper do, where others take the name of the model. See `topic_of`.
    """
    if site.namespace is None and site.element.child("robotNamespace") is None:
        name = "/" + name.strip("/")
    return topic_of(site, tag, name)
