"""Reads the tag of a plugin into its parameters, and from these names of topics and frames, and offsets.

Source: gazebo_ros_utils for defaults that are said; sdformat for how a bool is written.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

from simkit.errors import near_names
from simkit.geometry import Quaternion, Vector, canonical, quaternion_from_rpy
from simkit.graph.names import is_legal_name
from simkit.plugins.registry import SILENT, TagField, tags_of
from simkit.plugins.site import PluginError, Site
from simkit.xml import Element

T = TypeVar("T")
_TRUE, _FALSE = ("true", "1"), ("false", "0")


def read_parameters(parameters: type[T], site: Site, *, speaker: str | None = None) -> T:
    """What the tag of a plugin says.

    A tag that it does not read is named in a warning with the nearest one that it does; not for a URDF, of which
    check_urdf has said it already.

    Args:
        parameters: The parameter class of the plugin.
        site: Where the plugin works.
        speaker: What a missing tag is reported as, with its default, as the original does; None for
            a plugin that takes defaults in silence.

    Raises:
        PluginError: A value is not one that the tag can have, or a tag is missing that must be there.
    """
    values: dict[str, Any] = {}
    known = tags_of(parameters)
    for field, found in known.items():
        element = site.element.child(found.name)
        if element is not None:
            values[field] = _value(found, element, site)
        elif found.required:
            raise PluginError(
                f"{site.place(site.element)}: the plugin {site.name} needs <{found.name}>: {found.text}"
            )
        elif speaker is not None:
            shown = _shown(found.default)
            site.node.warn(f"{speaker}: missing <{found.name}> default is {shown}")
    if site.robot is None:
        _name_strangers(site, [one.name for one in known.values()])
    return parameters(**values)


def _value(found: TagField, element: Element, site: Site) -> Any:
    kind, text = type(found.default), element.text.strip()
    try:
        value = _READERS[kind](text)
    except ValueError:
        raise PluginError(
            f"{site.place(element)}: <{found.name}> is {_NOUNS[kind]}, not {text!r}. {found.text}"
        ) from None
    if kind in (float, int) and not (value >= found.at_least and value > found.above):
        bound = f"at least {found.at_least:g}" if math.isfinite(found.at_least) else "positive"
        raise PluginError(
            f"{site.place(element)}: <{found.name}> is {text}, and must be {bound}. {found.text}"
        )
    if found.choices and value not in found.choices:
        raise PluginError(
            f"{site.place(element)}: <{found.name}> is {text!r}, and must be one of: {', '.join(found.choices)}"
        )
    return value


def _name_strangers(site: Site, known: list[str]) -> None:
    for child in site.element.children:
        if child.name in known or child.name in SILENT:
            continue
        near = near_names(child.name, known)
        hint = f"; did you mean <{near[0]}>?" if near else ""
        site.node.warn(
            f"{site.place(child)}: the plugin {site.name} does not read <{child.name}>{hint}"
        )


def _shown(value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:g}" if isinstance(value, float) else str(value)


def _number(text: str) -> float:
    value = float(text)
    if not math.isfinite(value) or "_" in text:
        raise ValueError(text)
    return value


def _bool(text: str) -> bool:
    if text.lower() not in _TRUE + _FALSE:
        raise ValueError(text)
    return text.lower() in _TRUE


_READERS: dict[type[Any], Callable[[str], Any]] = {
    str: str,
    float: _number,
    int: int,
    bool: _bool,
}
_NOUNS = {str: "a text", float: "a number", int: "a whole number", bool: "true or false"}


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
        f"{site.place(element)}: there can be no topic {topic!r}, which <{tag}> and the namespace make: "
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
        where = site.place(site.element.child(name) or site.element)
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
