"""What several plugins read from the texts of their tags: names of topics and frames, offsets."""

from __future__ import annotations

import math

from simkit.geometry import Quaternion, Vector, canonical, quaternion_from_rpy
from simkit.graph.names import is_legal_name
from simkit.plugins.errors import PluginError
from simkit.plugins.parameters import place
from simkit.plugins.site import Site


def topic_of(site: Site, tag: str, name: str) -> str:
    """The global name of a topic that a plugin is given.

    Args:
        site: Where the plugin works.
        tag: Tag that the name is from, to be named in the error.
        name: The name: in the namespace of the robot, unless it begins with a slash.

    Raises:
        PluginError: There can be no topic of that name.
    """
    topic = site.resolve(name)
    if name.strip("/") and is_legal_name(topic):
        return topic
    element = site.element.child(tag) or site.element.child("robotNamespace") or site.element
    raise PluginError(
        f"{place(element, site)}: there can be no topic {topic!r}, which <{tag}> and the namespace make: "
        "a name has letters, digits, _ and / only, and a letter first"
    )


def tf_prefix(site: Site) -> str:
    """The parameter `tf_prefix` that is nearest to the namespace of the robot; empty if there is none."""
    params = site.node.graph.params
    found = params.search(f"/{site.robot_namespace}", "tf_prefix")
    value = "" if found is None else params.get(found, "")
    return value.strip("/") if isinstance(value, str) else ""


def resolve_frame(name: str, prefix: str) -> str:
    """A frame with its prefix; one that begins with a slash has none, and loses the slash."""
    if name.startswith("/"):
        return name[1:]
    return f"{prefix}/{name}" if prefix else name


def shown_namespace(site: Site) -> str:
    """The namespace as gazebo_ros shows it: as it was written, and a slash; two of them at the root."""
    tag = site.element.child("robotNamespace")
    if tag is not None:
        return f"{tag.text.strip()}/"
    return f"{site.model.name if site.namespace is None else site.namespace}/"


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
