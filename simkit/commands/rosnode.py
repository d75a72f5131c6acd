"""`rosnode`: which nodes are up, what they publish and subscribe to, and how to end them.

Source: rosnode of ROS Noetic, outputs and texts; where ROS shows the address of a process, the
name of the node stands here.
"""

from __future__ import annotations

import itertools

from simkit.commands.command import Answer, Call, Wait, subcommands
from simkit.commands.errors import ToolError, near_hint
from simkit.commands.graph_facts import (
    address,
    is_below,
    nodes,
    publishers,
    resolved,
    service_nodes,
    subscribers,
    topic_types,
)
from simkit.commands.parser import ArgumentParser
from simkit.graph import Graph

GRACE_SECONDS = 2.0
"""How long a node may take to end [s]."""


def list_nodes(graph: Graph, namespace: str = "/", *, addresses: bool = False) -> str:
    """What `rosnode list` prints: the names of the nodes, with `addresses` as `-a`."""
    within = resolved(namespace)
    names = [name for name in nodes(graph) if is_below(name, within)]
    return "\n".join(f"{name} \t{address(name)}" if addresses else name for name in names) + "\n"


def info(graph: Graph, node: str) -> str:
    """What `rosnode info` prints: topics, services and connections of a node.

    Raises:
        ToolError: There is no such node.
    """
    name = resolved(node)
    text = f"{'-' * 80}\n{_endpoints(graph, name)}\n"
    if name not in nodes(graph):
        raise ToolError(
            f"{text}cannot contact [{name}]: unknown node{near_hint(name, nodes(graph))}",
            exit_code=0,
        )
    return f"{text}\ncontacting node {address(name)} ...\n{_connections(graph, name)}\n"


def ping(graph: Graph, node: str, *, count: float = 1) -> Answer:
    """Ask a node whether it is up, once a second, as `rosnode ping -c COUNT` does.

    Args:
        graph: The graph.
        node: Node name.
        count: How often; a second passes between two questions.

    Raises:
        ToolError: There is no such node.
    """
    name = resolved(node)
    yield f"rosnode: node is [{name}]\n"
    for number in itertools.takewhile(lambda number: number < count, itertools.count()):
        if name not in nodes(graph):
            raise ToolError(f"cannot ping [{name}]: unknown node{near_hint(name, nodes(graph))}")
        if number == 0:
            yield f"pinging {name} with a timeout of 3.0s\n"
        # Within one instant of virtual time every node answers.
        yield f"xmlrpc reply from {address(name)}\ttime={0.0:f}ms\n"
        if number + 1 < count:
            yield Wait(seconds=1.0)
    if count > 1:
        yield f"ping average: {0.0:f}ms\n"


def kill(graph: Graph, *names: str) -> Answer:
    """End nodes, as `rosnode kill` does.

    Args:
        graph: The graph; time passes until the nodes have ended.
        *names: Node names.

    Raises:
        ToolError: One of them is unknown; then none is ended.
    """
    wanted = [resolved(name) for name in names]
    unknown = [name for name in wanted if name not in nodes(graph)]
    if unknown:
        listed = "\n".join(f" * {name}" for name in unknown)
        hint = near_hint(unknown[0], nodes(graph))
        raise ToolError(f"ERROR: Unknown node(s):\n{listed}{hint}")
    if len(wanted) == 1:
        yield f"killing {wanted[0]}\n"
    else:
        yield "killing:\n" + "\n".join(f" * {name}" for name in wanted) + "\n"
    ending = [graph.nodes[name] for name in dict.fromkeys(wanted)]
    for node in ending:
        node.shutdown()
    yield Wait(until=lambda: not any(node.alive for node in ending), seconds=GRACE_SECONDS)
    yield "killed\n"


def _endpoints(graph: Graph, node: str) -> str:
    types = topic_types(graph)
    parts = [f"Node [{node}]"]
    for title, table in (
        ("Publications", publishers(graph)),
        ("Subscriptions", subscribers(graph)),
    ):
        lines = [f" * {topic} [{types[topic]}]" for topic, who in table.items() if node in who]
        parts.append(_section(title, lines))
    services = [f" * {name}" for name, server in service_nodes(graph).items() if server == node]
    return "\n".join([*parts, _section("Services", services)])


def _section(title: str, lines: list[str]) -> str:
    return f"{title}: \n" + "\n".join(lines) + "\n" if lines else f"{title}: None\n"


def _connections(graph: Graph, node: str) -> str:
    lines: list[str] = []
    publishing, subscribing = publishers(graph), subscribers(graph)
    for mine, others, direction in (
        (publishing, subscribing, "outbound"),
        (subscribing, publishing, "inbound"),
    ):
        for topic, who in mine.items():
            for other in others.get(topic, ()) if node in who else ():
                lines += [
                    f" * topic: {topic}",
                    f"    * to: {other}",
                    f"    * direction: {direction}",
                    "    * transport: simkit",
                ]
    return "\n".join(["Connections:", *lines]) + "\n" if lines else ""


def _list_command(call: Call) -> Answer:
    parser = ArgumentParser("rosnode list")
    parser.add_argument("-a", "--all", action="store_true", help="addresses too")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    yield list_nodes(call.graph, found.namespace, addresses=found.all)


def _info_command(call: Call) -> Answer:
    parser = ArgumentParser("rosnode info")
    parser.add_argument("nodes", nargs="+", metavar="node")
    for name in parser.parse_args(call.words).nodes:
        yield info(call.graph, name)


def _ping_command(call: Call) -> Answer:
    parser = ArgumentParser("rosnode ping")
    parser.add_argument("-c", dest="count", type=int, help="so often")
    parser.add_argument("-a", "--all", action="store_true", help="all nodes, once each")
    parser.add_argument("node", nargs="?")
    found = parser.parse_args(call.words)
    if found.all == (found.node is not None):
        parser.error("Please enter a node to ping, or --all")
    names = nodes(call.graph) if found.all else [found.node]
    count = found.count or (1 if found.all else max(1.0, call.bounds.seconds))
    for name in names:
        yield from ping(call.graph, name, count=count)


def _kill_command(call: Call) -> Answer:
    parser = ArgumentParser("rosnode kill")
    parser.add_argument("-a", "--all", action="store_true", help="all nodes")
    parser.add_argument("nodes", nargs="*", metavar="node")
    found = parser.parse_args(call.words)
    if found.all and found.nodes:
        parser.error("invalid arguments with kill all (-a) option")
    names = nodes(call.graph) if found.all else found.nodes
    if not names:
        known = "\n".join(nodes(call.graph))
        raise ToolError(
            f"Please name the node to kill. Nodes:\n{known}" if known else "No nodes running"
        )
    yield from kill(call.graph, *names)


COMMANDS = {
    "info": _info_command,
    "kill": _kill_command,
    "list": _list_command,
    "ping": _ping_command,
}
"""The commands of rosnode by name."""
run = subcommands("rosnode", COMMANDS)
