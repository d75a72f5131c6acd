"""The commands of `rostopic` that go on, as programs on a node: `hz`, `pub`, and what a watcher of a topic is.

Source:
    rostopic's `ROSTopicHz`: mean, extremes and deviation of the gaps between messages.
"""

from __future__ import annotations

import math
from collections import deque
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

LONGEST_WINDOW = 50_000
"""So many messages count when no window is given."""
REPORT_EVERY = Duration(1)
"""How often the rate is printed."""
_POLL = Duration.from_nsec(100_000_000)
"How often a topic that does not exist yet is looked for."


class TopicProgram(Protocol):
    """What `rostopic echo`, `hz` or `pub` does on its node until it is done."""

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


class TopicHz(TopicWatcher):
    """Prints the rate of a topic once a second.

    Args:
        node: The node that listens.
        words: The topic.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.
        window: So many of the latest messages count.
    """

    def __init__(
        self,
        node: Node,
        words: str,
        write: Write,
        on_done: Callable[[], None] | None = None,
        *,
        window: int = LONGEST_WINDOW,
    ) -> None:
        self._gaps: deque[float] = deque(maxlen=max(1, window - 1))
        self._last: int | None = None
        self._last_reported: int | None = None
        super().__init__(node, words, write, on_done)

    def _listen(self, found: Found) -> None:
        graph = self.node.graph
        self.node.subscriptions.append(
            graph.add_subscription(
                found.topic, found.message_class, self.node.name, lambda _data, _by: self._note()
            )
        )
        self._write(f"subscribed to [{found.topic}]\n")
        self.node.create_timer(REPORT_EVERY, self._report)

    def _note(self) -> None:
        now = self.node.now().to_nsec()
        if self._last is not None:
            self._gaps.append((now - self._last) / 1e9)
        self._last = now

    def _report(self) -> None:
        if not self._gaps or self._last == self._last_reported:
            self._write("no new messages\n")
            return
        self._last_reported = self._last
        self._write(rate_text(list(self._gaps)))


def rate_text(gaps: list[float]) -> str:
    """What `rostopic hz` prints of the gaps between messages [s]."""
    mean = sum(gaps) / len(gaps)
    deviation = math.sqrt(sum((gap - mean) ** 2 for gap in gaps) / len(gaps))
    rate = 1.0 / mean if mean > 0.0 else 0.0
    return (
        f"average rate: {rate:.3f}\n"
        f"\tmin: {min(gaps):.3f}s max: {max(gaps):.3f}s "
        f"std dev: {deviation:.5f}s window: {len(gaps) + 1}\n"
    )


def start_hz(
    node: Node, words: Sequence[str], write: Write, on_done: Callable[[], None] | None = None
) -> TopicHz:
    """Begin `rostopic hz [-w WINDOW] /topic`.

    Args:
        node: The node that listens.
        words: The words after `rostopic hz`.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.

    Raises:
        UsageError: The words ask for nothing.
    """
    parser = ArgumentParser("rostopic hz")
    parser.add_argument("-w", "--window", type=int, default=LONGEST_WINDOW)
    parser.add_argument("topic")
    found = parser.parse_args(words)
    if found.window < 2:
        parser.error("WINDOW must be at least 2 messages")
    return TopicHz(node, found.topic, write, on_done, window=found.window)


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
