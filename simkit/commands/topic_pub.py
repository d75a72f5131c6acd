"""`rostopic pub`: publishes a message that is written as YAML."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import yaml

from simkit.commands.errors import ToolError, UsageError, near_hint
from simkit.commands.graph_facts import resolved
from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import Graph, Node
from simkit.graph.names import free_name
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
from simkit.msgs.strify import message_text

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
        once: Whether it is done when the message was latched for `ONCE_SECONDS`.
        on_done: Called then.

    Attributes:
        done: Whether that is over.
        fault: None.
        goes_on: Whether it goes on where nobody presses Ctrl-C.

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
        once: bool = False,
        on_done: Callable[[], None] | None = None,
    ) -> None:
        self.goes_on = not once
        self.done = False
        self.fault: ToolError | None = None
        self._on_done = on_done
        _require_sendable(message)
        publisher = node.advertise(topic, type(message), latch=latch or rate is None)
        publisher.publish(message)
        if rate is not None:
            period = Duration.from_nsec(round(1e9 / rate))
            node.create_timer(period, lambda: publisher.publish(message))
        if once:
            node.create_timer(Duration.from_nsec(round(ONCE_SECONDS * 1e9)), self._finish)

    def _finish(self) -> None:
        self.done = True
        if self._on_done is not None:
            self._on_done()


def publish(
    graph: Graph,
    topic: str,
    type_name: str,
    values: Sequence[object],
    *,
    rate: float | None = None,
    latch: bool = False,
) -> Node:
    """A new node that publishes a message: once and latched, or again and again.

    Args:
        graph: Where it publishes.
        topic: Topic name.
        type_name: `geometry_msgs/Twist`.
        values: As for `message_of`.
        rate: Messages per second [Hz]; once if None.
        latch: Give the last message to later subscribers also if `rate` is given.

    Raises:
        ToolError: No such type, a value does not fit, or the rate is not above 0.
    """
    if rate is not None and (fault := rate_fault(rate)):
        raise UsageError(f"rostopic pub: error: {fault}")
    message = message_of(type_name, values, graph.now())
    node = graph.create_node(free_name("/rostopic", graph.nodes))
    try:
        TopicPub(node, resolved(topic), message, rate=rate, latch=latch)
    except SimkitError:
        node.shutdown()
        raise
    return node


def rate_fault(rate: float) -> str:
    """What rostopic says of a rate that cannot be; empty if it can."""
    return "" if 0.0 < rate < math.inf else "rate must be greater than zero"


def message_of(type_name: str, values: Sequence[object], now: Time) -> Message:
    """The message that values mean: one for the whole, or one for each field.

    Args:
        type_name: `geometry_msgs/Twist`.
        values: `[{"linear": {"x": 1.0}}]` or `[[1, 0, 0], [0, 0, 2]]`, or a message.
        now: What `stamp: now` and `header: auto` stand for.

    Raises:
        ToolError: No such type, or a value does not fit; lists the fields.
    """
    made = message_type(type_name)
    if len(values) == 1 and isinstance(values[0], Message):
        if values[0]._type != type_name:
            raise ToolError(f"ERROR: the message is a {values[0]._type}, not a {type_name}")
        return values[0]
    try:
        return fill_message(made, list(values), now=now)
    except MessageError as error:
        raise ToolError(f"ERROR: {error}\n\nArgs are: [{' '.join(field_paths(made()))}]") from error


def message_type(type_name: str) -> type[Message]:
    """The class of a type of messages.

    Raises:
        ToolError: There is no such type.
    """
    try:
        return message_class(type_name)
    except UnknownNameError as error:
        hint = near_hint(type_name, message_types())
        raise ToolError(f"ERROR: invalid message type: {type_name}.{hint}") from error


def value_of(word: str) -> object:
    """The value that YAML on the command line of `rostopic pub` means.

    Raises:
        UsageError: It is not YAML.
    """
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
