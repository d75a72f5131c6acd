"""Graph side: what a script's process asks of topics."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.graph.log import LogLevel
from simkit.graph.process import protocol
from simkit.graph.process.endpoint_table import EndpointTable
from simkit.graph.process.protocol import Op, ProtocolError
from simkit.graph.topics import Publisher, Subscription
from simkit.msgs import DeserializationError, message_class

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode

MAX_QUEUE = 1_000_000
"""Longest queue of a subscription [messages]."""


class TopicRequests:
    """Publishes and subscribes for one node."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        numbers = itertools.count(1)
        self._publishers: EndpointTable[Publisher] = EndpointTable(numbers, node.publishers)
        self._subscriptions: EndpointTable[Subscription] = EndpointTable(
            numbers, node.subscriptions
        )
        self._has_lost = False
        self.asked: dict[Op, Callable[[bytes], Any]] = {
            Op.ADVERTISE: self._advertise,
            Op.SUBSCRIBE: self._subscribe,
        }
        """What is answered, and how."""
        self.told: dict[Op, Callable[[bytes], None]] = {
            Op.PUBLISH: self._publish,
            Op.UNADVERTISE: self._publishers.drop,
            Op.UNSUBSCRIBE: self._subscriptions.drop,
        }
        """What is done without an answer."""

    def connections(self, number: int) -> int:
        """How many are at the other end of a publisher or subscription, by its number."""
        endpoint = self._publishers.get(number) or self._subscriptions.get(number)
        return endpoint.num_connections if endpoint else 0

    def _advertise(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        node = self._node
        topic = node.resolve(request["topic"])
        if sentence := node.permissions.refuse_publishing(topic):
            return node.refuse(sentence)
        number = self._publishers.new_number()
        kind = message_class(request["type"])
        publisher = node.graph.add_publisher(topic, kind, node.name, latch=bool(request["latch"]))
        self._publishers.add(number, publisher)
        return {"id": number, "topic": topic}

    def _publish(self, body: bytes) -> None:
        number, data = protocol.unpack_id(body)
        publisher = self._publishers.get(number)
        if publisher is None or publisher.closed:
            return
        try:
            publisher.message_class.from_bytes(data)  # nothing malformed travels on
        except DeserializationError as error:
            raise ProtocolError(f"a message on {publisher.topic} is malformed: {error}") from error
        publisher.publish_bytes(data)

    def _subscribe(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        node = self._node
        topic = node.resolve(request["topic"])
        number = self._subscriptions.new_number()
        sink = self._sink(topic, number, stored=bool(request.get("stored")))
        subscription = node.graph.add_subscription(
            topic,
            message_class(request["type"]),
            node.name,
            sink,
            queue_size=_queue_size(request["queue_size"]),
        )
        self._subscriptions.add(number, subscription)
        return {"id": number, "topic": topic}

    def _sink(self, topic: str, number: int, *, stored: bool) -> Callable[[bytes, str], None]:
        """Brings the messages of a topic to the node."""
        head, tell = protocol.pack_id(number), self._node.tell

        def sink(data: bytes, caller: str) -> None:
            if not tell(Op.DELIVER, head, protocol.pack_name(caller), data, stored=stored):
                self._warn_of_loss(topic)

        return sink

    def _warn_of_loss(self, topic: str) -> None:
        if self._node.alive and not self._has_lost:
            self._has_lost = True
            text = f"messages on {topic} are lost: too many wait for this node at one instant"
            self._node.graph.log(self._node.name, LogLevel.WARN, text)


def _queue_size(value: object) -> int | None:
    if value is None:
        return None
    if isinstance(value, int) and 0 < value <= MAX_QUEUE:
        return value
    raise ProtocolError(f"{value!r:.80} is no length of a queue")
