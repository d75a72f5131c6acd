"""Graph side: what a script's process asks of the graph, operation by operation."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph import names
from simkit.graph.endpoint import keep_open_ones
from simkit.graph.log import LogLevel
from simkit.graph.process import protocol
from simkit.graph.process.protocol import Op, ProtocolError
from simkit.graph.services import Reply, ServiceServer
from simkit.graph.topics import Publisher, Subscription
from simkit.msgs import DeserializationError, message_class, service_class

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode

MAX_ENDPOINTS = 1000
"""Publishers, subscriptions and services that one script may have."""
MAX_LOG_TEXT = 10_000
"""Longest line of rosout that a script may say [characters]."""
MAX_QUEUE = 1_000_000
"""Longest queue of a subscription [messages]."""
MAX_KEPT = 64 * 1024 * 1024
"""How much a script may set in parameters over its life, and how much it may say on rosout [bytes]."""
LOG_OVERHEAD = 200
"""What keeping a line of rosout costs besides its text [bytes]."""
_LAST = (Op.WAIT, Op.ASK, Op.EXIT)


class Requests:
    """Performs the records of one node's frames."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._graph = node.graph
        self._remappings: dict[str, str] = {}
        self._publishers: dict[int, Publisher] = {}
        self._subscriptions: dict[int, Subscription] = {}
        self._servers: dict[int, ServiceServer] = {}
        self._calls: dict[int, tuple[Reply, Any]] = {}
        self._next_id = 0
        self._next_call = 0
        self._initialized = False
        self._parameter_bytes = 0
        self._log_bytes = 0
        self._dropped = False
        self._asked: dict[Op, Callable[[dict[str, Any]], Any]] = {
            Op.INIT_NODE: self._init_node,
            Op.ADVERTISE: self._advertise,
            Op.SUBSCRIBE: self._subscribe,
            Op.OFFER_SERVICE: self._offer_service,
            Op.PARAM: self._param,
            Op.QUERY: self._query,
        }
        self._told: dict[Op, Callable[[bytes], None]] = {
            Op.PUBLISH: self._publish,
            Op.UNADVERTISE: lambda body: self._drop(self._publishers, body),
            Op.UNSUBSCRIBE: lambda body: self._drop(self._subscriptions, body),
            Op.WITHDRAW_SERVICE: self._withdraw_service,
            Op.SERVICE_ANSWER: self._service_answer,
            Op.CALL: self._call,
            Op.LOG: self._log,
            Op.FAULT: lambda body: self._node.add_fault(protocol.unpack_json(body)),
        }

    def abandon_calls(self) -> None:
        """Fail the calls that this node was still to answer."""
        calls, self._calls = self._calls, {}
        for reply, _ in calls.values():
            reply(False, b"transport error completing service call: the server has ended")

    def perform(self, frame: bytes) -> tuple[Op, bytes]:
        """Do what a frame asks for; its last record says how the node goes on.

        Raises:
            ProtocolError: The frame is not of the protocol.
        """
        for op, body in protocol.records(frame):
            if op in _LAST:
                return op, body
            if op in self._told:
                self._told[op](body)
            elif op in self._asked:
                self._answer(op, body)
            else:
                raise ProtocolError(f"{op.name} is not for a node to say")
        raise ProtocolError("a frame has no end")

    def _answer(self, op: Op, body: bytes) -> None:
        request = protocol.unpack_json(body)
        if op is Op.PARAM:
            self._parameter_bytes += len(body)
        try:
            reply = self._asked[op](request)
        except SimkitError as error:
            reply = {"error": str(error)}
        except (KeyError, TypeError, AttributeError, ValueError) as error:
            raise ProtocolError(f"{op.name} lacks something: {error!r}") from error
        self._node.outbox.add_json(Op.REPLY, reply)

    # -- names

    def _resolve(self, name: str) -> str:
        return names.resolve(name, self._node.name, self._remappings)

    def _init_node(self, request: dict[str, Any]) -> dict[str, Any]:
        node, line = self._node, self._node.command_line
        if self._initialized:
            raise ProtocolError("a process is one node only")
        base = line.node_name or str(request["name"])
        if not names.is_legal_node_name(base):
            return {
                "error": f"init_node: {base!r} is not a node name: letters, digits and _ only, a letter first"
            }
        if request["anonymous"] and line.node_name is None:
            base = f"{base}_{self._anonymous_number(base)}"
        before, node.name = node.name, names.join(line.namespace, base)
        try:
            self._remappings = line.resolved_remappings(node.name)
            self._graph.add_node(node)
        except SimkitError:
            node.name = before
            raise
        self._initialized = True
        for key, value in line.private_parameters.items():
            self._graph.params.set(self._resolve("~" + key), value)
        return {"name": node.name, "arguments": list(line.arguments)}

    def _anonymous_number(self, base: str) -> int:
        number = 1
        while (
            names.join(self._node.command_line.namespace, f"{base}_{number}") in self._graph.nodes
        ):
            number += 1
        return number

    # -- topics

    def _refuse(self, sentence: str) -> dict[str, str]:
        if sentence not in self._node.refusals:
            self._node.refusals.append(sentence)
            self._graph.log(self._node.name, LogLevel.ERROR, f"refused: {sentence}")
        return {"error": sentence}

    def _new_id(self, table: dict[int, Any]) -> int:
        if len(table) >= MAX_ENDPOINTS:
            raise SimkitError(
                f"a node may have {MAX_ENDPOINTS} publishers, subscribers and services of each kind"
            )
        self._next_id += 1
        return self._next_id

    def _advertise(self, request: dict[str, Any]) -> dict[str, Any]:
        topic = self._resolve(request["topic"])
        if sentence := self._node.permissions.refuse_publishing(topic):
            return self._refuse(sentence)
        number = self._new_id(self._publishers)
        publisher = self._graph.add_publisher(
            topic, message_class(request["type"]), self._node.name, latch=bool(request["latch"])
        )
        self._publishers[number] = keep_open_ones(publisher, self._node.publishers)
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

    def _subscribe(self, request: dict[str, Any]) -> dict[str, Any]:
        topic = self._resolve(request["topic"])
        number = self._new_id(self._subscriptions)
        head = protocol.pack_id(number)
        stored = bool(request.get("stored"))

        def sink(data: bytes, caller: str) -> None:
            if not self._node.tell(
                Op.DELIVER, head, protocol.pack_name(caller), data, stored=stored
            ):
                self._warn_of_loss(topic)

        subscription = self._graph.add_subscription(
            topic,
            message_class(request["type"]),
            self._node.name,
            sink,
            queue_size=_queue_size(request["queue_size"]),
        )
        self._subscriptions[number] = keep_open_ones(subscription, self._node.subscriptions)
        return {"id": number, "topic": topic}

    def _warn_of_loss(self, topic: str) -> None:
        if self._node.alive and not self._dropped:
            self._dropped = True
            text = f"messages on {topic} are lost: too many wait for this node at one instant"
            self._graph.log(self._node.name, LogLevel.WARN, text)

    def _drop(self, table: dict[int, Any], body: bytes) -> None:
        endpoint = table.pop(protocol.unpack_id(body)[0], None)
        if endpoint is not None:
            endpoint.unregister()

    # -- services

    def _offer_service(self, request: dict[str, Any]) -> dict[str, Any]:
        name = self._resolve(request["service"])
        if sentence := self._node.permissions.refuse_service(name):
            return self._refuse(sentence)
        number = self._new_id(self._servers)

        def respond(data: bytes, caller: str, reply: Reply) -> None:
            self._next_call += 1
            self._calls[self._next_call] = (reply, kind)
            ids = protocol.pack_id(self._next_call) + protocol.pack_id(number)
            self._node.tell(Op.SERVE, ids, protocol.pack_name(caller), data)
            if not self._node.alive:
                self.abandon_calls()

        kind = service_class(request["type"])
        server = self._graph.add_service(name, kind, self._node.name, respond)
        self._servers[number] = keep_open_ones(server, self._node.servers)
        return {"id": number, "service": name}

    def _withdraw_service(self, body: bytes) -> None:
        self._drop(self._servers, body)

    def _service_answer(self, body: bytes) -> None:
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
            self._node.tell(Op.CALL_RESULT, head, bytes([success]), answer)

        refusal = self._start_call(written, data, reply)
        if refusal:
            self._node.outbox.add(Op.CALL_RESULT, head, b"\0", refusal.encode())
            self._node.resume_soon()

    def _start_call(self, written: str, data: bytes, reply: Reply) -> str:
        """Call a service; why that cannot be, or an empty text."""
        try:
            service = self._resolve(written)
            if sentence := self._node.permissions.refuse_service(service):
                self._refuse(sentence)
                return sentence
            self._graph.call_service(service, data, self._node.name, reply)
        except UnknownNameError:
            return f"service [{service}] unavailable"
        except SimkitError as error:
            return str(error)
        return ""

    # -- parameters, rosout, questions

    def _param(self, request: dict[str, Any]) -> dict[str, Any]:
        params, do = self._graph.params, request["do"]
        if do == "names":
            return {"value": params.names()}
        if do == "search":
            return {"value": params.search(self._node.name, request["name"])}
        name = self._resolve(request["name"])
        if do == "has":
            return {"value": params.has(name)}
        if do == "get":
            return {"value": params.get(name)} if params.has(name) else {"missing": name}
        if sentence := self._node.permissions.refuse_parameter(name, self._node.name):
            return self._refuse(sentence)
        if do == "set":
            if self._parameter_bytes > MAX_KEPT:
                return {"error": "this node has set more parameters than it may"}
            params.set(name, request["value"])
        elif do == "delete":
            if not params.has(name):
                return {"missing": name}
            params.delete(name)
        return {}

    def _log(self, body: bytes) -> None:
        try:
            level = LogLevel(body[0])
        except (ValueError, IndexError) as error:
            raise ProtocolError("not a log level") from error
        text = body[1:].decode("utf-8", "replace")[:MAX_LOG_TEXT]
        before = self._log_bytes
        self._log_bytes += len(text) + LOG_OVERHEAD
        if self._log_bytes <= MAX_KEPT:
            self._graph.log(self._node.name, level, text)
        elif before <= MAX_KEPT:
            self._graph.log(
                self._node.name, LogLevel.WARN, "this node says too much; no more is kept"
            )

    def _query(self, request: dict[str, Any]) -> dict[str, Any]:
        what = request["what"]
        if what == "topics":
            return {"value": sorted(self._graph.topic_types(published=True).items())}
        if what == "service":
            name = self._resolve(request["name"])
            server = self._graph.services.get(name)
            return {"value": server.service_class._type if server else None, "name": name}
        if what == "resolve":
            return {"value": self._resolve(request["name"])}
        if what == "connections":
            endpoint = self._publishers.get(request["id"]) or self._subscriptions.get(request["id"])
            return {"value": endpoint.num_connections if endpoint else 0}
        raise ProtocolError(f"{what!r} is no question")


def _queue_size(value: object) -> int | None:
    if value is None:
        return None
    if isinstance(value, int) and 0 < value <= MAX_QUEUE:
        return value
    raise ProtocolError(f"{value!r:.80} is no length of a queue")
