"""Graph side: what a script's process asks of topics and services."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph.endpoint import Endpoint, keep_open_ones
from simkit.graph.log import LogLevel
from simkit.graph.process import protocol
from simkit.graph.process.protocol import Op, ProtocolError
from simkit.graph.services import Reply, ServiceServer
from simkit.graph.topics import Publisher, Subscription
from simkit.msgs import DeserializationError, message_class, service_class

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
        self.answered: dict[Op, Callable[[bytes], Any]] = {
            Op.ADVERTISE: self._advertise,
            Op.SUBSCRIBE: self._subscribe,
        }
        """What is answered, and how."""
        self.noted: dict[Op, Callable[[bytes], None]] = {
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
        head, post = protocol.pack_id(number), self._node.post

        def sink(data: bytes, caller: str) -> None:
            if not post(Op.DELIVER, head, protocol.pack_name(caller), data, stored=stored):
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


E = TypeVar("E", bound=Endpoint)

MAX_ENDPOINTS = 1000
"""Publishers, subscriptions and services that one script may have, of each kind."""


class EndpointTable(Generic[E]):
    """A node's endpoints of one kind.

    Args:
        numbers: Where new numbers come from; tables that share it have no number in common.
        open_ones: Where those are listed that are open.
    """

    def __init__(self, numbers: Iterator[int], open_ones: list[E]) -> None:
        self._numbers = numbers
        self._open_ones = open_ones
        self._by_number: dict[int, E] = {}

    def new_number(self) -> int:
        """A number for an endpoint to come.

        Raises:
            SimkitError: The node has too many.
        """
        if len(self._by_number) >= MAX_ENDPOINTS:
            raise SimkitError(
                f"a node may have {MAX_ENDPOINTS} publishers, subscribers and services of each kind"
            )
        return next(self._numbers)

    def add(self, number: int, endpoint: E) -> None:
        """Enter an endpoint under its number."""
        self._by_number[number] = keep_open_ones(endpoint, self._open_ones)

    def get(self, number: int) -> E | None:
        """The endpoint with a number."""
        return self._by_number.get(number)

    def drop(self, body: bytes) -> None:
        """End the endpoint whose number a record's body is, if there is one."""
        endpoint = self._by_number.pop(protocol.unpack_id(body)[0], None)
        if endpoint is not None:
            endpoint.unregister()


class ServiceRequests:
    """Offers and calls services for one node."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._servers: EndpointTable[ServiceServer] = EndpointTable(
            itertools.count(1), node.servers
        )
        self._calls: dict[int, tuple[Reply, Any]] = {}
        self._call_numbers = itertools.count(1)
        self.answered: dict[Op, Callable[[bytes], Any]] = {Op.OFFER_SERVICE: self._offer}
        """What is answered, and how."""
        self.noted: dict[Op, Callable[[bytes], None]] = {
            Op.WITHDRAW_SERVICE: self._servers.drop,
            Op.SERVICE_ANSWER: self._take_answer,
            Op.CALL: self._call,
        }
        """What is done without an answer."""

    def abandon_calls(self) -> None:
        """Fail the calls that this node was still to answer."""
        calls, self._calls = self._calls, {}
        for reply, _ in calls.values():
            reply(False, b"transport error completing service call: the server has ended")

    def _offer(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        node = self._node
        name = node.resolve(request["service"])
        if sentence := node.permissions.refuse_service(name):
            return node.refuse(sentence)
        number = self._servers.new_number()
        kind = service_class(request["type"])

        def respond(data: bytes, caller: str, reply: Reply) -> None:
            call = next(self._call_numbers)
            self._calls[call] = (reply, kind)
            ids = protocol.pack_id(call) + protocol.pack_id(number)
            node.post(Op.SERVE, ids, protocol.pack_name(caller), data)
            if not node.alive:
                self.abandon_calls()

        self._servers.add(number, node.graph.add_service(name, kind, node.name, respond))
        return {"id": number, "service": name}

    def _take_answer(self, body: bytes) -> None:
        number, rest = protocol.unpack_id(body)
        if number not in self._calls:
            return
        reply, kind = self._calls.pop(number)
        success, answer = rest[:1] == b"\x01", rest[1:]
        if success:
            try:
                kind._response_class.from_bytes(answer)  # nothing malformed travels on
            except DeserializationError as error:
                reply(False, b"the server's response is malformed")
                raise ProtocolError(f"a response of {kind._type} is malformed: {error}") from error
        reply(success, answer)

    def _call(self, body: bytes) -> None:
        number, rest = protocol.unpack_id(body)
        written, data = protocol.unpack_name(rest)
        head = protocol.pack_id(number)

        def reply(success: bool, answer: bytes) -> None:
            self._node.post(Op.CALL_RESULT, head, bytes([success]), answer)

        refusal = self._start_call(written, data, reply)
        if refusal:
            self._node.outbox.add(Op.CALL_RESULT, head, b"\0", refusal.encode())
            self._node.resume_soon()

    def _start_call(self, written: str, data: bytes, reply: Reply) -> str:
        """Call a service; why that cannot be, or an empty text."""
        node = self._node
        try:
            service = node.resolve(written)
            if sentence := node.permissions.refuse_service(service):
                node.refuse(sentence)
                return sentence
            node.graph.call_service(service, data, node.name, reply)
        except UnknownNameError:
            return f"service [{service}] unavailable"
        except SimkitError as error:
            return str(error)
        return ""
