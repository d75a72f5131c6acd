"""Reads the tag of a plugin into its parameters.

Source: gazebo_ros_utils for defaults that are said; sdformat for how a bool is written.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

from simkit.errors import near_names
from simkit.plugins.errors import PluginError
from simkit.plugins.site import Site
from simkit.plugins.tags import SILENT, TagField, tags_of
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
                f"{place(site.element, site)}: the plugin {site.name} needs <{found.name}>: {found.text}"
            )
        elif speaker is not None:
            shown = _shown(found.default)
            site.node.warn(f"{speaker}: missing <{found.name}> default is {shown}")
    if site.robot is None:
        _name_strangers(site, [one.name for one in known.values()])
    return parameters(**values)


def place(element: Element, site: Site) -> str:
    """Where a tag stands, to begin a sentence with."""
    return f"{site.file or site.model.name}:{element.span.line}:{element.span.column}"


def _value(found: TagField, element: Element, site: Site) -> Any:
    kind, text = type(found.default), element.text.strip()
    try:
        value = _READERS[kind](text)
    except ValueError:
        raise PluginError(
            f"{place(element, site)}: <{found.name}> is {_NOUNS[kind]}, not {text!r}. {found.text}"
        ) from None
    if kind in (float, int) and not (value >= found.at_least and value > found.above):
        bound = f"at least {found.at_least:g}" if math.isfinite(found.at_least) else "positive"
        raise PluginError(
            f"{place(element, site)}: <{found.name}> is {text}, and must be {bound}. {found.text}"
        )
    if found.choices and value not in found.choices:
        raise PluginError(
            f"{place(element, site)}: <{found.name}> is {text!r}, and must be one of: {', '.join(found.choices)}"
        )
    return value


def _name_strangers(site: Site, known: list[str]) -> None:
    for child in site.element.children:
        if child.name in known or child.name in SILENT:
            continue
        near = near_names(child.name, known)
        hint = f"; did you mean <{near[0]}>?" if near else ""
        site.node.warn(
            f"{place(child, site)}: the plugin {site.name} does not read <{child.name}>{hint}"
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
