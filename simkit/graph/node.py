"""A node that lives in this process: what turtlesim, the plugins and a simulation's own tools are built on."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from simkit.graph import names
from simkit.graph.endpoint import keep_open_ones
from simkit.graph.log import LogLevel
from simkit.graph.services import ServiceServer, immediate_responder
from simkit.graph.topics import Publisher, Subscription, decoding_sink
from simkit.msgs import Duration, Message, Time

if TYPE_CHECKING:
    from simkit.graph.executor import Executor, ScheduledEvent
    from simkit.graph.graph import Graph

_NO_DEFAULT = object()
MessageT = TypeVar("MessageT", bound=Message)


class Timer:
    """Calls back every period of virtual time, first one period after its creation."""

    def __init__(self, executor: Executor, period_ns: int, callback: Callable[[], None]) -> None:
        self._executor = executor
        self._period_ns = max(1, period_ns)
        self._callback = callback
        self.cancelled = False
        self._event: ScheduledEvent = executor.call_at(
            executor.now_ns + self._period_ns, self._fire
        )

    def cancel(self) -> None:
        """Never call back again."""
        self.cancelled = True
        self._event.cancel()

    def _fire(self) -> None:
        # Scheduled before the callback runs, so that the callback may cancel it.
        self._event = self._executor.call_at(self._executor.now_ns + self._period_ns, self._fire)
        self._callback()


class Node:
    """One node of the graph, in this process; made by `Graph.create_node`."""

    def __init__(
        self, graph: Graph, name: str, remappings: Mapping[str, str] | None = None
    ) -> None:
        self.graph = graph
        self.name = name
        self.remappings = dict(remappings or {})
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []
        self.servers: list[ServiceServer] = []
        self._timers: list[Timer] = []
        self._on_shutdown: list[Callable[[], None]] = []
        self.alive = True

    def __repr__(self) -> str:
        return f"<node {self.name}, {'running' if self.alive else 'ended'}>"

    @property
    def seed(self) -> int:
        """Seed of everything random in this node; adding another node does not change it."""
        return zlib.crc32(f"{self.graph.seed}{self.name}".encode())

    def now(self) -> Time:
        """Virtual time."""
        return self.graph.now()

    def resolve(self, name: str) -> str:
        """Global name that `name` stands for in this node, remappings applied."""
        return names.resolve(name, self.name, self.remappings)

    def advertise(
        self,
        topic: str,
        message_class: type[Message],
        *,
        latch: bool = False,
        queue_size: int | None = None,  # noqa: ARG002 - rospy's argument; nothing waits on the way out here
    ) -> Publisher:
        """Publish on a topic.

        Args:
            topic: Name, resolved in this node.
            message_class: Class of the messages.
            latch: Give the last message to each later subscriber.
            queue_size: Taken for rospy's sake; delivery is immediate, so nothing queues here.
        """
        publisher = self.graph.add_publisher(
            self.resolve(topic), message_class, self.name, latch=latch
        )
        return keep_open_ones(publisher, self.publishers)

    def subscribe(
        self,
        topic: str,
        message_class: type[MessageT],
        callback: Callable[[MessageT], None],
        *,
        queue_size: int | None = None,
    ) -> Subscription:
        """Call back with each message of a topic, as this subscriber's own copy.

        Args:
            topic: Name, resolved in this node.
            message_class: Class of the messages.
            callback: Takes a message; `message._connection_header["callerid"]` names its publisher.
            queue_size: At most so many messages of one instant wait; the oldest is dropped.
        """
        resolved = self.resolve(topic)
        sink = decoding_sink(message_class, callback, resolved)  # type: ignore[arg-type]
        subscription = self.graph.add_subscription(
            resolved, message_class, self.name, sink, queue_size=queue_size
        )
        return keep_open_ones(subscription, self.subscriptions)

    def advertise_service(
        self, service: str, service_class: Any, handler: Callable[[Any], Message]
    ) -> ServiceServer:
        """Answer calls of a service.

        Args:
            service: Name, resolved in this node.
            service_class: Class of the service, from `simkit.msgs.service_class`.
            handler: Takes a request, gives a response; raises `ServiceFailed` to fail the call.
        """
        server = self.graph.add_service(
            self.resolve(service),
            service_class,
            self.name,
            immediate_responder(service_class, handler),
        )
        return keep_open_ones(server, self.servers)

    def create_timer(self, period: Duration, callback: Callable[[], None]) -> Timer:
        """Call back every `period` of virtual time, first one period from now."""
        timer = Timer(self.graph.executor, period.to_nsec(), callback)
        self._timers = [*(other for other in self._timers if not other.cancelled), timer]
        return timer

    def get_param(self, name: str, default: Any = _NO_DEFAULT) -> Any:
        """Value of a parameter (`~x` is private); raises UnknownNameError without a default."""
        if default is _NO_DEFAULT:
            return self.graph.params.get(self.resolve(name))
        return self.graph.params.get(self.resolve(name), default)

    def set_param(self, name: str, value: Any) -> None:
        """Set a parameter."""
        self.graph.params.set(self.resolve(name), value)

    def has_param(self, name: str) -> bool:
        """Whether a parameter is set."""
        return self.graph.params.has(self.resolve(name))

    def log(self, level: LogLevel, text: str) -> None:
        """Say something on rosout."""
        self.graph.log(self.name, level, text)

    def debug(self, text: str) -> None:
        """Log at level DEBUG."""
        self.log(LogLevel.DEBUG, text)

    def info(self, text: str) -> None:
        """Log at level INFO."""
        self.log(LogLevel.INFO, text)

    def warn(self, text: str) -> None:
        """Log at level WARN."""
        self.log(LogLevel.WARN, text)

    def error(self, text: str) -> None:
        """Log at level ERROR."""
        self.log(LogLevel.ERROR, text)

    def fatal(self, text: str) -> None:
        """Log at level FATAL."""
        self.log(LogLevel.FATAL, text)

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Call back when the node leaves the graph."""
        self._on_shutdown.append(callback)

    def shutdown(self) -> None:
        """Leave the graph: topics, services and timers of this node end."""
        if not self.alive:
            return
        self.alive = False
        for callback in self._on_shutdown:
            callback()
        self.close_endpoints()
        self.graph.remove_node(self)

    def close_endpoints(self) -> None:
        """End this node's topics, services and timers."""
        for endpoint in (*self.publishers, *self.subscriptions, *self.servers):
            endpoint.unregister()
        for timer in self._timers:
            timer.cancel()
