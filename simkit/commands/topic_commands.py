"""The command lines of `rostopic` that go on: `echo`, `hz` and `pub`."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from simkit.commands.command import Answer, Call, Wait
from simkit.commands.errors import ToolError
from simkit.commands.graph_facts import publishers, resolved
from simkit.commands.parser import ArgumentParser
from simkit.commands.topic_echo import EchoForm, TopicEcho
from simkit.commands.topic_hz import LONGEST_WINDOW, TopicHz
from simkit.commands.topic_pub import (
    ONCE_SECONDS,
    announcement,
    has_fields,
    publish,
    rate_fault,
    value_of,
)
from simkit.commands.topic_search import TopicWatcher, find_topic, similar_topic
from simkit.graph import Graph
from simkit.graph.names import free_name


def echo_command(call: Call) -> Answer:
    """`rostopic echo [-n COUNT] [-p] [--noarr] [--nostr] /topic[/field]`."""
    topic, form = read_echo(call.words)
    printed: list[str] = []
    node = call.graph.create_node(free_name("/rostopic", call.graph.nodes))
    watcher = TopicEcho(node, topic, printed.append, form=form)
    enough = call.bounds.messages
    yield from _watch(call, watcher, printed, until=lambda: watcher.printed == enough)
    if watcher.printed == 0:
        raise ToolError(_silence(call.graph, topic, call.bounds.seconds))
    if form.count is None and watcher.printed == enough:
        yield f"({enough} messages; -n COUNT shows so many)\n"


def hz_command(call: Call) -> Answer:
    """`rostopic hz [-w WINDOW] /topic`."""
    topic, window = read_hz(call.words)
    printed: list[str] = []
    node = call.graph.create_node(free_name("/rostopic", call.graph.nodes))
    watcher = TopicHz(node, topic, printed.append, window=window)
    yield from _watch(call, watcher, printed)


def pub_command(call: Call) -> Answer:
    """`rostopic pub [-1 | -r RATE] [-l] /topic type [YAML...]`.

    Where it is bounded, in a notebook, the node goes on.
    """
    line = read_pub(call.words)
    values = [value_of(word) for word in line.words]
    node = publish(call.graph, line.topic, line.type_name, values, rate=line.rate, latch=line.latch)
    yield announcement(rate=line.rate, once=line.once)
    if math.isinf(call.bounds.seconds) or line.once:
        try:
            yield Wait(seconds=ONCE_SECONDS if line.once else math.inf)
        finally:
            node.shutdown()


def _watch(
    call: Call,
    watcher: TopicWatcher,
    printed: list[str],
    until: Callable[[], bool] = lambda: False,
) -> Answer:
    """Give what a watcher prints until it is done, or the time is over; its node ends with it."""
    end = call.sim.now.to_sec() + call.bounds.seconds

    def is_over() -> bool:
        return watcher.done or until()

    try:
        while not is_over() and (left := end - call.sim.now.to_sec()) > 0:
            yield Wait(until=lambda: bool(printed) or is_over(), seconds=left)
            yield "".join(printed)
            printed.clear()
    finally:
        watcher.node.shutdown()
    yield "".join(printed)
    if watcher.fault is not None:
        raise watcher.fault


def _silence(graph: Graph, topic: str, seconds: float) -> str:
    found = find_topic(graph, topic)
    said = f"nothing was said on {resolved(topic)} within {seconds:g} s"
    if found is None:
        return f"{said}: there is no such topic{similar_topic(graph, topic)}"
    speakers = publishers(graph).get(found.topic, [])
    return f"{said}: {', '.join(speakers) or 'nobody'} publishes it"


def read_echo(words: Sequence[str]) -> tuple[str, EchoForm]:
    """Topic and form that the words after `rostopic echo` ask for.

    Raises:
        UsageError: They ask for nothing.
    """
    parser = ArgumentParser("rostopic echo")
    parser.add_argument("-n", dest="count", type=int, help="stop after so many messages")
    parser.add_argument("-p", dest="csv", action="store_true", help="as rows of numbers")
    parser.add_argument("-c", "--clear", action="store_true", help="no effect here")
    parser.add_argument("--noarr", action="store_true", help="arrays by their length")
    parser.add_argument("--nostr", action="store_true", help="strings by their length")
    parser.add_argument("topic")
    found = parser.parse_args(words)
    if found.count is not None and found.count < 1:
        parser.error("COUNT must be at least 1")
    return found.topic, EchoForm(
        count=found.count, csv=found.csv, arrays=not found.noarr, strings=not found.nostr
    )


def read_hz(words: Sequence[str]) -> tuple[str, int]:
    """Topic and window that the words after `rostopic hz` ask for.

    Raises:
        UsageError: They ask for nothing.
    """
    parser = ArgumentParser("rostopic hz")
    parser.add_argument("-w", "--window", type=int, default=LONGEST_WINDOW)
    parser.add_argument("topic")
    found = parser.parse_args(words)
    if found.window < 2:
        parser.error("WINDOW must be at least 2 messages")
    return found.topic, found.window


@dataclass(frozen=True, slots=True, kw_only=True)
class PubLine:
    """What the words after `rostopic pub` ask for."""

    topic: str
    "Topic name."
    type_name: str
    "Type of the message."
    words: tuple[str, ...]
    "YAML of the message, or of each of its fields."
    rate: float | None
    "Messages per second [Hz]."
    once: bool
    "Whether to stop when it has been heard."
    latch: bool
    "Whether to latch also when there is a rate."


def read_pub(words: Sequence[str]) -> PubLine:
    """What the words after `rostopic pub` ask for.

    Raises:
        UsageError: They ask for nothing.
        ToolError: There is no such type.
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
    if not found.args and has_fields(found.type):
        parser.error("Please specify message values")
    return PubLine(
        topic=found.topic,
        type_name=found.type,
        words=tuple(found.args),
        rate=None if found.rate is None else _rate(parser, found.rate),
        once=found.once,
        latch=found.latch,
    )


def _rate(parser: ArgumentParser, word: str) -> float:
    try:
        rate = float(word)
    except ValueError:
        parser.error("rate must be a number")
    if fault := rate_fault(rate):
        parser.error(fault)
    return rate
