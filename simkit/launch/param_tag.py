"""`<param name value|textfile|binfile|command type>`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.errors import near_names
from simkit.graph.names import is_legal_name
from simkit.launch.command import output_of
from simkit.launch.refusal import Kind, Lesson, Refused
from simkit.launch.rules import ATTRIBUTE
from simkit.launch.scope import PrivateParameter, Scope, joined
from simkit.launch.tag import Tag
from simkit.launch.values import TYPES, convert

_ATTRIBUTES = ("name", "value", "type", "textfile", "binfile", "command")
_SOURCES = ("value", "textfile", "binfile", "command")
_OTHER_WORDS = {"file": ["textfile"], "default": ["value"]}


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
            _how_to_have_one(tag, len(sources)),
        )
    name = tag.required("name", scope).strip()
    ((source, text),) = sources.items()
    try:
        found = _value(tag, name, type_name, source, text)
    except Refused as refused:
        raise refused.at(tag.place_of(source if type_name in TYPES else "type")) from None
    _check_name(tag, name)
    if in_node or name.startswith("~"):
        scope.add_parameter(PrivateParameter(name, found.value, (tag.place, found.source)))
    else:
        full = joined(scope.namespace, name)
        tag.state.add_param(full, found.value, tag.place, found.source)


def _how_to_have_one(tag: Tag, count: int) -> str:
    """What to do about a parameter with no source, or with several."""
    if count:
        return "Keep one of value=, textfile=, binfile=, command=."
    for attribute in tag.element.attributes:
        near = _OTHER_WORDS.get(attribute.name) or near_names(attribute.name, _SOURCES)
        if attribute.name not in _ATTRIBUTES and near:
            return f"Write {near[0]}= where {attribute.name}= stands."
    return 'Write value="...", or textfile=, binfile= or command=.'


def _check_name(tag: Tag, name: str) -> None:
    """Tell of a name that the tools of ROS refuse; roslaunch itself takes it."""
    if not name or is_legal_name(name):
        return
    what = f"{name!r} is no legal name of a parameter: rosparam does not read it"
    remedy = "Use letters, digits, _ and / only, a letter first."
    tag.state.teach(Lesson(rule=ATTRIBUTE, what=what, remedy=remedy), tag.place_of("name"))


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
