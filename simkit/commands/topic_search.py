"""From the words `/turtle1/pose/x` to a topic and a field of its messages."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from simkit.commands.errors import ToolError, near_hint
from simkit.commands.graph_facts import resolved, topic_types
from simkit.errors import near_names
from simkit.graph import Graph
from simkit.msgs import Message, message_class

_PART = re.compile(r"(?P<name>\w+)(\[(?P<index>-?\d+)\]|\[(?P<slice>-?\d*:-?\d*)\])?")


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """A topic, or a part of its messages."""

    topic: str
    "Resolved name of the topic."
    type_name: str
    "Type of its messages."
    field: str = ""
    "What follows the topic's name, `pose/position/x`; empty for the whole message."

    @property
    def message_class(self) -> type[Message]:
        """Class of the messages."""
        return message_class(self.type_name)

    @property
    def field_type(self) -> str:
        """Type of the field as a definition spells it.

        Raises:
            ToolError: There is no such field; names near ones.
        """
        kind = self.type_name
        for part in self.field.split("/") if self.field else ():
            made = message_class(kind)
            match = _PART.fullmatch(part)
            name = match["name"] if match else part
            if name not in made.__slots__:
                raise ToolError(_no_field(self.field, name, list(made.__slots__)))
            kind = made._slot_types[list(made.__slots__).index(name)]
            if match and match["index"]:
                kind = kind.partition("[")[0]
        return kind

    def value(self, message: Message) -> Any:
        """The field of a message; the message itself if no field was asked for.

        Raises:
            ToolError: An index is too large.
        """
        value: Any = message
        for part in self.field.split("/") if self.field else ():
            match = _PART.fullmatch(part)
            assert match is not None  # `field_type` has been asked
            value = getattr(value, match["name"])
            try:
                value = _item(value, match)
            except IndexError:
                raise ToolError(f"{part}: the array has {len(value)} elements") from None
        return value


def find_topic(graph: Graph, words: str) -> Found | None:
    """The topic that words mean, with the field behind its name; None if no node uses it.

    Raises:
        GraphError: The words are no legal name.
    """
    types = topic_types(graph)
    name = "/" + words.strip("/")
    if name in types:
        return Found(topic=name, type_name=types[name])
    for topic in sorted(types, key=len, reverse=True):
        if name.startswith(topic + "/"):
            return Found(topic=topic, type_name=types[topic], field=name[len(topic) + 1 :])
    resolved(words)
    return None


def similar_topic(graph: Graph, words: str) -> str:
    """A line with the topic that may have been meant; empty if none is near."""
    return near_hint("/" + words.strip("/"), topic_types(graph))


def _item(value: Any, match: re.Match[str]) -> Any:
    if match["index"]:
        return value[int(match["index"])]
    if match["slice"]:
        start, _, stop = match["slice"].partition(":")
        return value[int(start) if start else None : int(stop) if stop else None]
    return value


def _no_field(field: str, name: str, names: list[str]) -> str:
    near = near_names(name, names)
    meant = f"; did you mean {near[0]}?" if near else ";"
    return f"no field named [/{field}]{meant} Fields: {', '.join(names)}"
