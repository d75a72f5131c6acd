"""`<param name value|textfile|binfile|command type>`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.launch.command import output_of
from simkit.launch.refusal import Kind, Refused
from simkit.launch.scope import PrivateParameter, Scope, joined
from simkit.launch.tag import Tag
from simkit.launch.values import convert

_ATTRIBUTES = ("name", "value", "type", "textfile", "binfile", "command")
_SOURCES = ("value", "textfile", "binfile", "command")


@dataclass(frozen=True, slots=True)
class _Found:
    """A value, and the file that it was read from."""

    value: Any
    source: Path | None = None


def take_param(tag: Tag, scope: Scope, *, in_node: bool = False) -> None:
    """Add a parameter: to the server, or, with `~` and in a node, to nodes.

    Args:
        tag: The tag.
        scope: Where it stands.
        in_node: Whether it stands in a `<node>`: then it is private, whatever its name.

    Raises:
        Refused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    try:
        _add(tag, scope, in_node=in_node)
    except Refused as refused:
        refused.at(tag.place)
        if refused.kind is Kind.KEY:
            words = f"<param> tag is missing required attribute: {refused.text}. \n\nParam xml is"
        elif refused.kind is Kind.VALUE:
            words = f"Invalid <param> tag: {refused.text}. \n\nParam xml is"
        else:
            raise
        raise refused.worded(Kind.SYNTAX, f"{words} {tag.xml}") from None


def _add(tag: Tag, scope: Scope, *, in_node: bool) -> None:
    tag.check_attributes(_ATTRIBUTES)
    type_name = (tag.element.get("type") or "auto").lower().strip()
    sources = {key: value for key in _SOURCES if (value := tag.get(key, scope)) is not None}
    if len(sources) != 1:
        raise tag.refuse(
            "<param> tag must have one and only one of value/textfile/binfile.",
            f"a parameter has one source, and here are {len(sources)}",
            "Keep one of value=, textfile=, binfile=, command=.",
        )
    name = tag.required("name", scope).strip()
    ((source, text),) = sources.items()
    try:
        found = _value(tag, name, type_name, source, text)
    except Refused as refused:
        raise refused.at(tag.place_of(source)) from None
    if in_node or name.startswith("~"):
        scope.add_parameter(PrivateParameter(name, found.value, (tag.place, found.source)))
    else:
        full = joined(scope.namespace, name)
        tag.state.add_param(full, found.value, tag.place, found.source)


def _value(tag: Tag, name: str, type_name: str, source: str, text: str) -> _Found:
    files = tag.state.files
    if source == "value":
        return _Found(convert(text.strip(), type_name))
    if source == "textfile":
        return _Found(convert(files.read_text(text), type_name), Path(text))
    if source == "binfile":
        return _Found(files.read(text), Path(text))
    output = output_of(text, parameter=name, files=files)
    return _Found(convert(output.text, type_name), output.source)
