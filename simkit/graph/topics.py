"""Topics: publishers, subscriptions, latching, queues.

A message is serialised once, when it is published: types are checked where the fault is, and what is delivered, recorded and
compared are the same bytes.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable

from simkit.graph.endpoint import Endpoint
from simkit.graph.errors import GraphError
from simkit.graph.executor import Executor
from simkit.msgs import Message

Sink = Callable[[bytes, str], None]
"""Takes the wire bytes of a message and the name of the node that published it."""


class Topic:
    """One topic: its type, who is on it, and the last message."""

    def __init__(self, name: str, message_class: type[Message], executor: Executor) -> None:
        self.name = name
        self.message_class = message_class
        self.executor = executor
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []
        self._last: Callable[[], bytes] | bytes | None = None

    @property
    def last(self) -> bytes | None:
        """Wire bytes of the last message, None if there was none."""
        if self._last is not None and not isinstance(self._last, bytes):
            self._last = self._last()
        return self._last

    def keep(self, make: Callable[[], bytes]) -> None:
        """Take a message that nobody hears: its bytes are made when `last` is asked for."""
        self._last = make

    def deliver(self, data: bytes, caller: str) -> None:
        """Hand wire bytes to every subscription, as events of this instant."""
        self._last = data
        for subscription in list(self.subscriptions):
            subscription.push(data, caller)

    @property
    def in_use(self) -> bool:
        """Whether any node publishes or subscribes."""
        return bool(self.publishers or self.subscriptions)


class Publisher(Endpoint):
    """A publisher of a topic.

    A latching publisher gives its last message to each later subscriber, as in rospy.
    """

    def __init__(
        self, topic: Topic, node_name: str, *, latch: bool, connected: bool = True
    ) -> None:
        super().__init__(node_name)
        self.since_ns = topic.executor.now_ns
        self._topic = topic
        self._connected = connected
        self._sequence = 0
        self._latched: bytes | None = None
        self.latch = latch
        if connected:
            topic.publishers.append(self)

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._topic.name

    @property
    def message_class(self) -> type[Message]:
        """Class of the messages."""
        return self._topic.message_class

    @property
    def num_connections(self) -> int:
        """How many subscriptions this publisher has."""
        return len(self._topic.subscriptions) if self._connected else 0

    def publish(self, message: Message) -> None:
        """Send a message; `header.seq` is counted here, as rospy does.

        Raises:
            GraphError: The publisher has ended, or the message is of another class.
            SerializationError: A field has a value of the wrong type; the message names the field.
        """
        self._sequence += 1
        self.publish_bytes(self._encoded(message, self._sequence))

    def offer(self, make: Callable[[], Message]) -> None:
        """Send a message that is made only if somebody listens, or asks later what was sent last.

        Args:
            make: Makes the message, of what was known when it was offered.
        """
        if self.closed or self.latch or not self._connected or self._topic.subscriptions:
            self.publish(make())
            return
        self._sequence += 1
        number = self._sequence
        self._topic.keep(lambda: self._encoded(make(), number))

    def publish_bytes(self, data: bytes) -> None:
        """Send a message that is in wire format already."""
        if self.closed:
            raise GraphError(f"publish() to a closed topic {self.topic}")
        if self.latch:
            self._latched = data
        if self._connected:
            self._topic.deliver(data, self.node_name)

    def greet(self, subscription: Subscription) -> None:
        """Give a new subscription the latched message."""
        if self._latched is not None:
            subscription.push(self._latched, self.node_name)

    def _encoded(self, message: Message, sequence: int) -> bytes:
        if not isinstance(message, self._topic.message_class):
            raise GraphError(
                f"topic {self.topic} carries {self._topic.message_class._type}, "
                f"not {type(message).__name__}"
            )
        if message._has_header:
            message.header.seq = sequence
        return message.to_bytes()

    def _leave(self) -> None:
        if self._connected:
            self._topic.publishers.remove(self)


class Subscription(Endpoint):
    """A subscriber of a topic: a queue in front of a sink.

    Args:
        topic: The topic.
        node_name: Resolved name of the subscribing node.
        sink: Takes each message's bytes and the publisher's node name.
        queue_size: At most so many wait; the oldest is dropped. None: no bound.
        connected: False for a subscription whose type is not the topic's; it receives nothing.
    """

    def __init__(
        self,
        topic: Topic,
        node_name: str,
        sink: Sink,
        *,
        queue_size: int | None = None,
        connected: bool = True,
    ) -> None:
        super().__init__(node_name)
        self.since_ns = topic.executor.now_ns
        self._topic = topic
        self._connected = connected
        self._sink = sink
        self._waiting: deque[tuple[bytes, str]] = deque(maxlen=queue_size or None)
        if connected:
            topic.subscriptions.append(self)
            for publisher in topic.publishers:
                publisher.greet(self)

    @property
    def topic(self) -> str:
        """Resolved name of the topic."""
        return self._topic.name

    @property
    def num_connections(self) -> int:
        """How many publishers it receives from."""
        return len(self._topic.publishers)

    def push(self, data: bytes, caller: str) -> None:
        """Queue a message for delivery at this instant."""
        self._waiting.append((data, caller))
        self._topic.executor.call_soon(self._deliver_one)

    def _leave(self) -> None:
        self._waiting.clear()
        if self._connected:
            self._topic.subscriptions.remove(self)

    def _deliver_one(self) -> None:
        # A full queue dropped its oldest message, but not that message's event: then there is nothing to do.
        if self._waiting:
            self._sink(*self._waiting.popleft())


def decoding_sink(
    message_class: type[Message], callback: Callable[[Message], None], topic: str
) -> Sink:
    """A sink that gives `callback` its own copy of each message, with rospy's `_connection_header`."""

    def sink(data: bytes, caller: str) -> None:
        message = message_class.from_bytes(data)
        message._connection_header = {
            "callerid": caller,
            "topic": topic,
            "type": message_class._type,
        }
        callback(message)

    return sink
