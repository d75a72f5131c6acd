"""Topics with nobody at the other end, whose names are near to one in use: most often a typing error."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from simkit.errors import near_names
from simkit.graph.graph import Graph, GraphNode
from simkit.graph.log import LogLevel, LogRecord
from simkit.graph.topics import Publisher, Subscription, Topic

PATIENCE_NS = 2_000_000_000
"""So long a topic may wait for its other end before a word is said [ns of virtual time]."""
_LOOK_NS = 500_000_000
"""Time between two looks, at least [ns of virtual time]."""


def unmatched_topics(
    graph: Graph, node: GraphNode, whose: str = "this node", *, at_least_ns: int = 0
) -> dict[str, str]:
    """What to say about each topic of a node that has no other end while a near one of its type is in use.

    Args:
        graph: Where the node is.
        node: The node.
        whose: What to call it.
        at_least_ns: Leave out topics that the node came to later than so long ago [ns of virtual time].
    """
    latest_ns = graph.executor.now_ns - at_least_ns
    ends: list[Subscription | Publisher] = [*node.subscriptions, *node.publishers]
    used = {end.topic for end in ends}
    said = {}
    for end in ends:
        topic = graph.topics.get(end.topic)
        is_unmatched = topic is not None and not (topic.publishers and topic.subscriptions)
        if topic is None or not is_unmatched or end.since_ns > latest_ns:
            continue
        is_heard = isinstance(end, Subscription)
        if near := _near(topic.name, set(_same_type(graph, topic, is_published=is_heard)) - used):
            does, lack = ("listens to", "publishes") if is_heard else ("publishes", "listens to")
            said[topic.name] = (
                f"{whose} {does} {topic.name}, which no node {lack}; did you mean {near}?"
            )
    return said


def _same_type(graph: Graph, topic: Topic, *, is_published: bool) -> Iterator[str]:
    """Where a node could find the other end: topics that are published, or that wait for a publisher."""
    for name, other in graph.topics.items():
        is_free = other.publishers if is_published else not other.publishers and other.subscriptions
        if other is not topic and is_free and other.message_class is topic.message_class:
            yield name


def _near(name: str, known: set[str]) -> str:
    """The name that was meant: one that is spelled alike, or the same in another namespace."""
    last = name.rpartition("/")[2]
    same = [one for one in sorted(known) if one.rpartition("/")[2] == last]
    return next(iter([*near_names(name, known, limit=1), *same]), "")


class TopicHints:
    """Says on the screen, once for each node and topic, which name may have been meant; the log is left as it is.

    Args:
        graph: Where the nodes are.
        nodes: Those that are looked at; more may join the list.
    """

    def __init__(self, graph: Graph, nodes: Sequence[GraphNode]) -> None:
        self._graph = graph
        self._nodes = nodes
        self._looked_ns = graph.executor.now_ns
        self._said: set[tuple[str, str]] = set()

    def look(self) -> None:
        """Look at topics that have waited for a while; now and then, for it is called after each event."""
        now_ns = self._graph.executor.now_ns
        if self._graph.screen is None or now_ns - self._looked_ns < _LOOK_NS:
            return
        self._looked_ns = now_ns
        for node in self._nodes:
            for topic, text in unmatched_topics(self._graph, node, at_least_ns=PATIENCE_NS).items():
                if (node.name, topic) not in self._said:
                    self._said.add((node.name, topic))
                    self._graph.screen.record(
                        LogRecord(
                            time=self._graph.now(), node=node.name, level=LogLevel.WARN, text=text
                        )
                    )
