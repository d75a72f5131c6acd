"""The graph itself: what rosmaster, rosout and the parameter server know."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Protocol

from simkit.errors import UnknownNameError
from simkit.graph.errors import GraphError
from simkit.graph.executor import Executor
from simkit.graph.log import LogLevel, LogRecord, Screen
from simkit.graph.names import is_legal_name
from simkit.graph.node import Node
from simkit.graph.params import ParameterServer
from simkit.graph.services import Reply, Responder, ServiceServer
from simkit.graph.topics import Publisher, Sink, Subscription, Topic
from simkit.msgs import Message, Time


class GraphNode(Protocol):
    """What the graph knows of a node, wherever it runs."""

    name: str
    alive: bool
    publishers: list[Publisher]
    subscriptions: list[Subscription]
    servers: list[ServiceServer]

    def shutdown(self) -> None:
        """Leave the graph."""


class Graph:
    """Topics, services, parameters, nodes and their log, on one executor.

    Args:
        executor: Owner of the virtual clock.
        screen: Where a person reads along (a terminal, a notebook); None keeps silent.
        seed: Of everything random; each node has one of its own from it.

    Attributes:
        muted: Nodes of which the screen shows warnings and errors only, and what to call when something was not shown.
        departures: What to call when a node has left the graph.
    """

    def __init__(self, executor: Executor, screen: Screen | None = None, *, seed: int = 0) -> None:
        self.executor = executor
        self.seed = seed
        self.params = ParameterServer()
        self.topics: dict[str, Topic] = {}
        self.services: dict[str, ServiceServer] = {}
        self.nodes: dict[str, GraphNode] = {}
        self.reserved_names: set[str] = set()
        self.records: list[LogRecord] = []
        self.screen = screen
        self.muted: dict[str, Callable[[], None]] = {}
        self.departures: list[Callable[[], None]] = []

    def now(self) -> Time:
        """Virtual time."""
        return Time.from_nsec(self.executor.now_ns)

    def log(self, node_name: str, level: LogLevel, text: str) -> None:
        """Keep (and show) a line of rosout."""
        record = LogRecord(time=self.now(), node=node_name, level=level, text=text)
        self.records.append(record)
        if self.screen is None:
            return
        if level < LogLevel.WARN and node_name in self.muted:
            self.muted[node_name]()
        else:
            self.screen.record(record)

    def show_output(self, node_name: str, text: str) -> None:
        """Show what a node has printed."""
        if self.screen is None:
            return
        if node_name in self.muted:
            self.muted[node_name]()
        else:
            self.screen.output(node_name, text)

    def create_node(self, name: str, remappings: Mapping[str, str] | None = None) -> Node:
        """A node in this process.

        Args:
            name: Resolved name, e.g. `/turtlesim`.
            remappings: Between resolved names.
        """
        node = Node(self, name, remappings)
        self.add_node(node)
        return node

    def add_node(self, node: GraphNode) -> None:
        """Register a node; one of the same name is shut down first, as rosmaster does."""
        if not is_legal_name(node.name):
            raise GraphError(f"{node.name!r} is not a legal node name")
        if node.name in self.reserved_names:
            raise GraphError(f"the node name {node.name} is taken by the simulation itself")
        older = self.nodes.get(node.name)
        if older is not None:
            self.log(
                node.name, LogLevel.WARN, "shutdown request: new node registered with same name"
            )
            older.shutdown()
        self.nodes[node.name] = node

    def remove_node(self, node: GraphNode) -> None:
        """Forget a node that has ended."""
        if self.nodes.get(node.name) is node:
            del self.nodes[node.name]
        for call in list(self.departures):
            call()

    def add_publisher(
        self, topic: str, message_class: type[Message], node_name: str, *, latch: bool
    ) -> Publisher:
        """A publisher on a resolved topic; of another type than the topic's, it is heard by nobody."""
        connected = self._type_fits(topic, message_class, node_name)
        return Publisher(
            self._topic(topic, message_class, own=not connected),
            node_name,
            latch=latch,
            connected=connected,
        )

    def add_subscription(
        self,
        topic: str,
        message_class: type[Message],
        node_name: str,
        sink: Sink,
        *,
        queue_size: int | None = None,
    ) -> Subscription:
        """A subscription to a resolved topic; of another type than the topic's, it receives nothing."""
        connected = self._type_fits(topic, message_class, node_name)
        return Subscription(
            self._topic(topic, message_class, own=not connected),
            node_name,
            sink,
            queue_size=queue_size,
            connected=connected,
        )

    def add_service(
        self, name: str, service_class: Any, node_name: str, respond: Responder
    ) -> ServiceServer:
        """A server for a resolved service name; a newer one replaces an older one, as in ROS."""
        server = ServiceServer(name, node_name, service_class, respond, self._remove_service)
        self.services[name] = server
        return server

    def call_service(self, name: str, request: bytes, caller: str, reply: Reply) -> None:
        """Call a resolved service as an event of this instant; `reply` takes the answer."""
        server = self.services.get(name)
        if server is None:
            raise UnknownNameError("service", name, self.services)
        self.executor.call_soon(lambda: server.respond(request, caller, reply))

    def topic_types(self, *, published: bool = False) -> dict[str, str]:
        """Type of each topic in use, sorted by name.

        Args:
            published: Leave out the topics that are only listened to.
        """
        return {
            name: topic.message_class._type
            for name, topic in sorted(self.topics.items())
            if (topic.publishers if published else topic.in_use)
        }

    def _remove_service(self, server: ServiceServer) -> None:
        if self.services.get(server.name) is server:
            del self.services[server.name]

    def _topic(self, name: str, message_class: type[Message], *, own: bool) -> Topic:
        if own:
            return Topic(name, message_class, self.executor)
        topic = self.topics.get(name)
        if topic is None or (topic.message_class._type != message_class._type):
            topic = self.topics[name] = Topic(name, message_class, self.executor)
        return topic

    def _type_fits(self, name: str, message_class: type[Message], node_name: str) -> bool:
        topic = self.topics.get(name)
        if topic is None or not topic.in_use or topic.message_class._type == message_class._type:
            return True
        self.log(
            node_name,
            LogLevel.ERROR,
            f"topic {name} carries {topic.message_class._type}, but this node uses it as "
            f"{message_class._type}: the two will not be connected",
        )
        return False
