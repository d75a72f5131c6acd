"""What the tools of ROS show of a graph: nodes, topics, services, without those of the simulation itself."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.graph import Graph, names


def resolved(name: str) -> str:
    """Global name that a word on a command line stands for.

    Raises:
        GraphError: It is no legal name.
    """
    return names.resolve(name, "/tool")


def publishers(graph: Graph) -> dict[str, list[str]]:
    """Nodes that publish each topic, sorted; a node of several publishers stands once."""
    found = (
        (name, {end.node_name for end in topic.publishers})
        for name, topic in sorted(graph.topics.items())
    )
    return _shown(graph, found)


def subscribers(graph: Graph) -> dict[str, list[str]]:
    """Nodes that subscribe to each topic, sorted; a node of several subscriptions stands once."""
    found = (
        (name, {end.node_name for end in topic.subscriptions})
        for name, topic in sorted(graph.topics.items())
    )
    return _shown(graph, found)


def topic_types(graph: Graph) -> dict[str, str]:
    """Type of each topic that a node uses, by name, sorted."""
    return {
        name: graph.topics[name].message_class._type
        for name in sorted({*publishers(graph), *subscribers(graph)})
    }


def nodes(graph: Graph) -> list[str]:
    """Names of the nodes that are up, sorted."""
    return sorted(set(graph.nodes) - graph.reserved_names)


def service_nodes(graph: Graph) -> dict[str, str]:
    """Node behind each service, by the service's name, sorted."""
    return {name: server.node_name for name, server in sorted(graph.services.items())}


def _shown(graph: Graph, table: Iterable[tuple[str, set[str]]]) -> dict[str, list[str]]:
    """The table without the nodes of the simulation itself, which no tool shows."""
    return {
        name: sorted(who - graph.reserved_names)
        for name, who in table
        if who - graph.reserved_names
    }


def address(node: str) -> str:
    """What stands where ROS shows the address of a node's process."""
    return f"simkit:/{node}"


def is_below(name: str, namespace: str) -> bool:
    """Whether a name is the namespace itself or lies in it."""
    return name == namespace or name.startswith(namespace.rstrip("/") + "/")
