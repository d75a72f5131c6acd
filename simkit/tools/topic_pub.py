"""`rostopic pub`: publishes a message that is written as YAML."""

from __future__ import annotations

from collections.abc import Sequence

import yaml

from simkit.errors import UnknownNameError
from simkit.graph import Node
from simkit.msgs import (
    Duration,
    Message,
    MessageError,
    SerializationError,
    Time,
    field_paths,
    fill_message,
    message_class,
    message_types,
)
from simkit.msgs.definition_text import message_text
from simkit.tools.errors import ToolError, UsageError, near_hint

ONCE_SECONDS = 3.0
"""How long a message that is published once stays latched [s]."""


class TopicPub:
    """Publishes one message: once and latched, or again and again.

    Args:
        node: The node that publishes.
        topic: Topic name.
        message: What to publish.
        rate: Messages per second [Hz]; once if None.
        latch: Give the last message to later subscribers; always if it is published once.

    Raises:
        ToolError: A field holds a value that its type cannot send.
    """

    def __init__(
        self,
        node: Node,
        topic: str,
        message: Message,
        *,
        rate: float | None = None,
        latch: bool = False,
    ) -> None:
        _require_sendable(message)
        publisher = node.advertise(topic, type(message), latch=latch or rate is None)
        publisher.publish(message)
        if rate is not None:
            period = Duration.from_nsec(round(1e9 / rate))
            node.create_timer(period, lambda: publisher.publish(message))


def announcement(*, rate: float | None, once: bool) -> str:
    """What `rostopic pub` prints when it begins; nothing if it repeats the message."""
    if rate is not None:
        return ""
    how_long = f" for {ONCE_SECONDS} seconds" if once else ". Press ctrl-C to terminate"
    return f"publishing and latching message{how_long}\n"


def message_from_words(type_name: str, words: Sequence[str], now: Time) -> Message:
    """The message that YAML words mean: one for the whole, or one for each field.

    Args:
        type_name: `geometry_msgs/Twist`.
        words: `["{linear: {x: 1.0}}"]` or `["[1, 0, 0]", "[0, 0, 2]"]`.
        now: What `stamp: now` and `header: auto` stand for.

    Raises:
        ToolError: No such type, or a value does not fit; lists the fields.
        UsageError: A word is not YAML.
    """
    made = _class(type_name)
    values = [_yaml(word) for word in words]
    try:
        return fill_message(made, values, now=now)
    except MessageError as error:
        raise ToolError(f"ERROR: {error}\n\nArgs are: [{' '.join(field_paths(made()))}]") from error


def has_fields(type_name: str) -> bool:
    """Whether a message of this type has anything to fill in.

    Raises:
        ToolError: There is no such type.
    """
    return bool(_class(type_name).__slots__)


def _class(type_name: str) -> type[Message]:
    try:
        return message_class(type_name)
    except UnknownNameError as error:
        hint = near_hint(type_name, message_types())
        raise ToolError(f"ERROR: invalid message type: {type_name}.{hint}") from error


def _yaml(word: str) -> object:
    try:
        return yaml.safe_load(word)
    except yaml.YAMLError as error:
        raise UsageError(f"rostopic pub: error: Argument error: {_one_line(error)}") from error


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())


def _require_sendable(message: Message) -> None:
    try:
        message.to_bytes()
    except SerializationError as error:
        raise ToolError(
            "ERROR: Unable to publish message. One of the fields has an incorrect type:\n"
            f"  {error}\n\nmsg file:\n{message_text(message._type)}"
        ) from error
