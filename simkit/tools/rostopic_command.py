"""The command lines of `rostopic`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from simkit.tools import rostopic
from simkit.tools.command_line import ArgumentParser, Call
from simkit.tools.topic_echo import EchoForm
from simkit.tools.topic_hz import LONGEST_WINDOW
from simkit.tools.topic_pub import has_fields, rate_fault


def list_command(call: Call) -> None:
    """`rostopic list [-v] [-p | -s] [/namespace]`."""
    parser = ArgumentParser("rostopic list")
    parser.add_argument("-v", "--verbose", action="store_true", help="types and numbers too")
    parser.add_argument("-p", dest="publishers", action="store_true", help="only publishers")
    parser.add_argument("-s", dest="subscribers", action="store_true", help="only subscribers")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    if found.publishers and found.subscribers:
        parser.error("you may only specify one of -p, -s")
    call.write(
        rostopic.list_topics(
            call.world.graph,
            found.namespace,
            verbose=found.verbose,
            publishers_only=found.publishers,
            subscribers_only=found.subscribers,
        )
    )


def info_command(call: Call) -> None:
    """`rostopic info /topic`."""
    call.write(rostopic.info(call.world.graph, _topic(call, "info")))


def type_command(call: Call) -> None:
    """`rostopic type /topic`."""
    call.write(rostopic.type_of(call.world.graph, _topic(call, "type")))


def find_command(call: Call) -> None:
    """`rostopic find type`."""
    parser = ArgumentParser("rostopic find")
    parser.add_argument("type", help="e.g. geometry_msgs/Twist")
    call.write(rostopic.find(call.world.graph, parser.parse_args(call.words).type))


def echo_command(call: Call) -> None:
    """`rostopic echo [-n COUNT] [-p] [--noarr] [--nostr] /topic[/field]`."""
    topic, form = read_echo(call.words)
    printed = rostopic.echo(call.world, topic, write=call.write, form=form, bounds=call.bounds)
    if form.count is None and printed == call.bounds.messages:
        call.write(f"({printed} messages; -n COUNT shows so many)\n")


def hz_command(call: Call) -> None:
    """`rostopic hz [-w WINDOW] /topic`."""
    topic, window = read_hz(call.words)
    rostopic.hz(call.world, topic, write=call.write, window=window, bounds=call.bounds)


def pub_command(call: Call) -> None:
    """`rostopic pub [-1 | -r RATE] [-l] /topic type [YAML...]`."""
    line = read_pub(call.words)
    rostopic.pub(
        call.world,
        line.topic,
        line.type_name,
        *line.words,
        rate=line.rate,
        once=line.once,
        latch=line.latch,
        write=call.write,
    )


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


def _topic(call: Call, command: str) -> str:
    parser = ArgumentParser(f"rostopic {command}")
    parser.add_argument("topic")
    return str(parser.parse_args(call.words).topic)


def _rate(parser: ArgumentParser, word: str) -> float:
    try:
        rate = float(word)
    except ValueError:
        parser.error("rate must be a number")
    if fault := rate_fault(rate):
        parser.error(fault)
    return rate


COMMANDS = {
    "echo": echo_command,
    "find": find_command,
    "hz": hz_command,
    "info": info_command,
    "list": list_command,
    "pub": pub_command,
    "type": type_command,
}
"""The commands of rostopic by name."""
