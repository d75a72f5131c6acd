"""`rostopic`: what topics there are, what is said on them, and saying something oneself.

Source: rostopic of ROS Noetic, outputs and texts.
"""

from __future__ import annotations

from collections.abc import Callable, Generator
from functools import partial
from typing import TypeVar

from simkit.commands.command import Answer, Call, Command, Wait, subcommands
from simkit.commands.errors import ToolError
from simkit.commands.graph_facts import (
    address,
    is_below,
    publishers,
    resolved,
    subscribers,
    topic_types,
)
from simkit.commands.parser import ArgumentParser
from simkit.commands.topic_echo import start_echo
from simkit.commands.topic_programs import TopicProgram, start_pub
from simkit.commands.topic_search import find_topic, similar_topic
from simkit.commands.topic_statistics import GAUGES, start_statistics
from simkit.graph import Graph
from simkit.graph.names import free_name

P = TypeVar("P", bound=TopicProgram)


def list_topics(
    graph: Graph,
    namespace: str = "/",
    *,
    verbose: bool = False,
    publishers_only: bool = False,
    subscribers_only: bool = False,
) -> str:
    """What `rostopic list` prints: names, or with `verbose` types and numbers too.

    Args:
        graph: The graph.
        namespace: Only topics in it.
        verbose: As `-v`.
        publishers_only: As `-p`.
        subscribers_only: As `-s`.
    """
    within = resolved(namespace)
    published, subscribed = (
        {name: nodes for name, nodes in table(graph).items() if is_below(name, within)}
        for table in (publishers, subscribers)
    )
    if not verbose:
        names = set(() if subscribers_only else published) | set(
            () if publishers_only else subscribed
        )
        return "\n".join(sorted(names)) + "\n"
    types, text = topic_types(graph), ""
    if not subscribers_only:
        text += f"\nPublished topics:\n{_counted(published, types, 'publisher')}"
    if not publishers_only:
        text += f"\nSubscribed topics:\n{_counted(subscribed, types, 'subscriber')}"
    return text + "\n"


def info(graph: Graph, topic: str) -> str:
    """What `rostopic info` prints: type, publishers, subscribers.

    Raises:
        ToolError: No node uses the topic.
    """
    name = resolved(topic)
    types = topic_types(graph)
    if name not in types:
        raise ToolError(f"ERROR: Unknown topic {name}{similar_topic(graph, name)}")
    parts = [f"Type: {types[name]}\n"]
    for role, table in (("Publishers", publishers(graph)), ("Subscribers", subscribers(graph))):
        lines = [f" * {node} ({address(node)})\n" for node in table.get(name, ())]
        parts.append(f"{role}: \n{''.join(lines)}" if lines else f"{role}: None\n")
    return "\n".join(parts) + "\n\n"


def type_of(graph: Graph, topic: str) -> str:
    """What `rostopic type` prints: the type of a topic, and of a field if one is named.

    Raises:
        ToolError: No node uses the topic, or its messages have no such field.
    """
    found = find_topic(graph, topic)
    if found is None:
        raise ToolError(
            f"unknown topic type [{resolved(topic)}]{similar_topic(graph, topic)}", exit_code=1
        )
    if not found.field:
        return f"{found.type_name}\n"
    return f"{found.type_name} {found.field} {found.field_type}\n"


def find(graph: Graph, type_name: str) -> str:
    """What `rostopic find` prints: the topics of a type."""
    types = topic_types(graph)
    return "\n".join(name for name, kind in types.items() if kind == type_name) + "\n"


def _counted(table: dict[str, list[str]], types: dict[str, str], role: str) -> str:
    return "".join(
        f" * {name} [{types[name]}] {len(nodes)} {role}{'s' if len(nodes) > 1 else ''}\n"
        for name, nodes in table.items()
    )


def echo_command(call: Call) -> Answer:
    """`rostopic echo`; where nobody presses Ctrl-C, a topic without messages is an error."""
    echo = yield from _run(call, partial(start_echo, most=call.bounds.messages))
    if echo.printed == 0:
        raise ToolError(_silence(call.graph, echo.words, call.bounds.seconds))


def _statistics(command: str) -> Command:
    def run(call: Call) -> Answer:
        yield from _run(call, partial(start_statistics, command=command))

    return run


def pub_command(call: Call) -> Answer:
    """`rostopic pub`; where nobody presses Ctrl-C, its node goes on."""
    yield from _run(call, start_pub)


def _run(call: Call, start: Callable[..., P]) -> Generator[str | Wait, None, P]:
    """Give what a program prints, on a node of its own, until it is done, or the time is over."""
    printed: list[str] = []
    node = call.graph.create_node(free_name("/rostopic", call.graph.nodes))
    goes_on = False
    try:
        program = start(node, call.words, printed.append)
        goes_on = call.leaves_nodes and program.goes_on
        end = call.sim.now.to_sec() + (0.0 if goes_on else call.bounds.seconds)
        while not program.done and (left := end - call.sim.now.to_sec()) > 0:
            yield Wait(until=lambda: bool(printed) or program.done, seconds=left)
            yield "".join(printed)
            printed.clear()
    finally:
        if not goes_on:
            node.shutdown()
    yield "".join(printed)
    if program.fault is not None:
        raise program.fault
    return program


def _silence(graph: Graph, topic: str, seconds: float) -> str:
    found = find_topic(graph, topic)
    said = f"nothing was said on {resolved(topic)} within {seconds:g} s"
    if found is None:
        return f"{said}: there is no such topic{similar_topic(graph, topic)}"
    speakers = publishers(graph).get(found.topic, [])
    return f"{said}: {', '.join(speakers) or 'nobody'} publishes it"


def list_command(call: Call) -> Answer:
    """`rostopic list [-v] [-p | -s] [/namespace]`."""
    parser = ArgumentParser("rostopic list")
    parser.add_argument("-v", "--verbose", action="store_true", help="types and numbers too")
    parser.add_argument("-p", dest="publishers", action="store_true", help="only publishers")
    parser.add_argument("-s", dest="subscribers", action="store_true", help="only subscribers")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    if found.publishers and found.subscribers:
        parser.error("you may only specify one of -p, -s")
    yield (
        list_topics(
            call.graph,
            found.namespace,
            verbose=found.verbose,
            publishers_only=found.publishers,
            subscribers_only=found.subscribers,
        )
    )


def info_command(call: Call) -> Answer:
    """`rostopic info /topic`."""
    yield info(call.graph, _topic(call, "info"))


def type_command(call: Call) -> Answer:
    """`rostopic type /topic`."""
    yield type_of(call.graph, _topic(call, "type"))


def find_command(call: Call) -> Answer:
    """`rostopic find type`."""
    parser = ArgumentParser("rostopic find")
    parser.add_argument("type", help="e.g. geometry_msgs/Twist")
    yield find(call.graph, parser.parse_args(call.words).type)


def _topic(call: Call, command: str) -> str:
    parser = ArgumentParser(f"rostopic {command}")
    parser.add_argument("topic")
    return str(parser.parse_args(call.words).topic)


COMMANDS = {
    **{command: _statistics(command) for command in GAUGES},
    "echo": echo_command,
    "find": find_command,
    "info": info_command,
    "list": list_command,
    "pub": pub_command,
    "type": type_command,
}
"""The commands of rostopic by name."""
run = subcommands("rostopic", COMMANDS)
