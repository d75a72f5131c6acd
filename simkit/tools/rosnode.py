"""`rosnode`: which nodes are up, what they speak and hear, and how to end them.

Source: rosnode of ROS Noetic, outputs and texts; where ROS shows the address of a process, the
name of the node stands here.
"""

from __future__ import annotations

from simkit.graph import Graph
from simkit.tools.command_line import ArgumentParser, Call
from simkit.tools.errors import ToolError, near_hint
from simkit.tools.world import (
    World,
    Write,
    address,
    is_below,
    nodes,
    publishers,
    resolved,
    service_nodes,
    subscribers,
    to_stdout,
    topic_types,
)

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


def ping(world: World, node: str, *, count: int = 1, write: Write = to_stdout) -> None:
    """Ask a node whether it is up, once a second, as `rosnode ping -c COUNT` does.

    Args:
        world: The simulation; a second passes between two questions.
        node: Node name.
        count: How often.
        write: Takes what is printed, line breaks included.

    Raises:
        ToolError: There is no such node.
    """
    name = resolved(node)
    write(f"rosnode: node is [{name}]\n")
    for number in range(count):
        if name not in nodes(world.graph):
            raise ToolError(
                f"cannot ping [{name}]: unknown node{near_hint(name, nodes(world.graph))}"
            )
        if number == 0:
            write(f"pinging {name} with a timeout of 3.0s\n")
        # Within one instant of virtual time every node answers.
        write(f"xmlrpc reply from {address(name)}\ttime={0.0:f}ms\n")
        if number + 1 < count:
            world.run_until(lambda: False, 1.0)
    if count > 1:
        write(f"ping average: {0.0:f}ms\n")


def kill(world: World, *names: str, write: Write = to_stdout) -> None:
    """End nodes, as `rosnode kill` does.

    Args:
        world: The simulation; time passes until the nodes have ended.
        *names: Node names.
        write: Takes what is printed, line breaks included.

    Raises:
        ToolError: One of them is unknown; then none is ended.
    """
    wanted = [resolved(name) for name in names]
    unknown = [name for name in wanted if name not in nodes(world.graph)]
    if unknown:
        listed = "\n".join(f" * {name}" for name in unknown)
        hint = near_hint(unknown[0], nodes(world.graph))
        raise ToolError(f"ERROR: Unknown node(s):\n{listed}{hint}")
    if len(wanted) == 1:
        write(f"killing {wanted[0]}\n")
    else:
        write("killing:\n" + "\n".join(f" * {name}" for name in wanted) + "\n")
    ending = [world.graph.nodes[name] for name in dict.fromkeys(wanted)]
    for node in ending:
        node.shutdown()
    world.run_until(lambda: not any(node.alive for node in ending), GRACE_SECONDS)
    write("killed\n")


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
    speakers, hearers = publishers(graph), subscribers(graph)
    for mine, others, direction in (
        (speakers, hearers, "outbound"),
        (hearers, speakers, "inbound"),
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


def _list_command(call: Call) -> None:
    parser = ArgumentParser("rosnode list")
    parser.add_argument("-a", "--all", action="store_true", help="addresses too")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    call.write(list_nodes(call.world.graph, found.namespace, addresses=found.all))


def _info_command(call: Call) -> None:
    parser = ArgumentParser("rosnode info")
    parser.add_argument("nodes", nargs="+", metavar="node")
    for name in parser.parse_args(call.words).nodes:
        call.write(info(call.world.graph, name))


def _ping_command(call: Call) -> None:
    parser = ArgumentParser("rosnode ping")
    parser.add_argument("-c", dest="count", type=int, help="so often")
    parser.add_argument("-a", "--all", action="store_true", help="all nodes, once each")
    parser.add_argument("node", nargs="?")
    found = parser.parse_args(call.words)
    if found.all == (found.node is not None):
        parser.error("Please enter a node to ping, or --all")
    names = nodes(call.world.graph) if found.all else [found.node]
    count = found.count or (1 if found.all else max(1, round(call.bounds.seconds)))
    for name in names:
        ping(call.world, name, count=count, write=call.write)


def _kill_command(call: Call) -> None:
    parser = ArgumentParser("rosnode kill")
    parser.add_argument("-a", "--all", action="store_true", help="all nodes")
    parser.add_argument("nodes", nargs="*", metavar="node")
    found = parser.parse_args(call.words)
    if found.all and found.nodes:
        parser.error("invalid arguments with kill all (-a) option")
    names = nodes(call.world.graph) if found.all else found.nodes
    if not names:
        known = "\n".join(nodes(call.world.graph))
        raise ToolError(
            f"Please name the node to kill. Nodes:\n{known}" if known else "No nodes running"
        )
    kill(call.world, *names, write=call.write)


COMMANDS = {
    "info": _info_command,
    "kill": _kill_command,
    "list": _list_command,
    "ping": _ping_command,
}
"""The commands of rosnode by name."""
