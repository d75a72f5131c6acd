"""The commands of `rostopic` that go on, as programs on a node: what they have in common, and `pub`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Protocol

from simkit.commands.command import Write
from simkit.commands.errors import ToolError
from simkit.commands.graph_facts import resolved
from simkit.commands.parser import ArgumentParser
from simkit.commands.topic_pub import (
    ONCE_SECONDS,
    TopicPub,
    message_of,
    message_type,
    rate_fault,
    value_of,
)
from simkit.commands.topic_search import Found, find_topic, similar_topic
from simkit.graph import Node
from simkit.msgs import Duration

_POLL = Duration.from_nsec(100_000_000)
"How often a topic that does not exist yet is looked for."


class TopicProgram(Protocol):
    """What `rostopic echo`, `hz`, `bw`, `delay` or `pub` does on its node until it is done."""

    done: bool
    "Whether it has nothing more to do."
    fault: ToolError | None
    "Why it is done, if that is an error."
    goes_on: bool
    "Whether it goes on where nobody presses Ctrl-C."


class TopicWatcher:
    """Waits until a topic is in use, then listens to it.

    Args:
        node: The node that listens.
        words: The topic, perhaps with a field.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.

    Attributes:
        node: The node.
        words: The topic.
        done: Whether nothing more will be printed.
        fault: Why it is done, if that is an error.
        goes_on: False: where nobody presses Ctrl-C, it ends.
    """

    def __init__(
        self, node: Node, words: str, write: Write, on_done: Callable[[], None] | None = None
    ) -> None:
        self.node = node
        self.words = words
        self.done = False
        self.fault: ToolError | None = None
        self.goes_on = False
        self._on_done = on_done
        self._write = write
        if not self._look():
            write(
                f"WARNING: topic [{resolved(words)}] does not appear to be published yet"
                f"{similar_topic(node.graph, words)}\n"
            )
            self._polling = node.create_timer(_POLL, self._look_again)

    def _look(self) -> bool:
        found = find_topic(self.node.graph, self.words)
        if found is not None:
            try:
                found.field_type  # noqa: B018 - asked for its error
                self._listen(found)
            except ToolError as error:
                self._finish(error)
        return found is not None

    def _look_again(self) -> None:
        if self._look():
            self._polling.cancel()

    def _finish(self, fault: ToolError | None = None) -> None:
        self.fault = fault
        self.done = True
        if self._on_done is not None:
            self._on_done()

    def _listen(self, found: Found) -> None:
        """Begin to listen; a subclass does it."""
        raise NotImplementedError


def start_pub(
    node: Node,
    words: Sequence[str],
    write: Write,
    on_done: Callable[[], None] | None = None,
) -> TopicPub:
    """Begin `rostopic pub [-1 | -r RATE] [-l] /topic type [YAML...]`.

    Args:
        node: The node that publishes.
        words: The words after `rostopic pub`.
        write: Takes what is printed.
        on_done: Called when it has published once, and long enough.

    Raises:
        UsageError: The words ask for nothing.
        ToolError: There is no such type, or a value does not fit.
    """
    parser = ArgumentParser("rostopic pub")
    parser.add_argument("-1", "--once", action="store_true", help="publish one message and stop")
    parser.add_argument("-r", "--rate", help="messages per second")
    parser.add_argument("-l", "--latch", action="store_true", help="latch also with -r")
    parser.add_argument("-v", "--verbose", action="store_true", help="no effect here")
    parser.add_argument("topic")
    parser.add_argument("type", help="e.g. geometry_msgs/Twist")
    parser.add_argument("args", nargs="*", help="YAML; after -- if it begins with -")
    found = parser.parse_intermixed_args(words)
    if found.once and found.rate is not None:
        parser.error("You cannot select both -r and -1 (--once)")
    if not found.args and message_type(found.type).__slots__:
        parser.error("Please specify message values")
    rate = None if found.rate is None else _rate(parser, found.rate)
    message = message_of(found.type, [value_of(word) for word in found.args], node.now())
    program = TopicPub(
        node,
        found.topic,
        message,
        rate=rate,
        latch=found.latch,
        once=found.once,
        on_done=on_done,
    )
    if rate is None:
        how_long = f" for {ONCE_SECONDS} seconds" if found.once else ". Press ctrl-C to terminate"
        write(f"publishing and latching message{how_long}\n")
    return program


def _rate(parser: ArgumentParser, word: str) -> float:
    try:
        rate = float(word)
    except ValueError:
        parser.error("rate must be a number")
    if fault := rate_fault(rate):
        parser.error(fault)
    return rate
