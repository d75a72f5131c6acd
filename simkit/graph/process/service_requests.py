"""Graph side: what a script's process asks of services: those that it offers, and those that it calls."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.graph.process import protocol
from simkit.graph.process.endpoint_table import EndpointTable
from simkit.graph.process.protocol import Op, ProtocolError
from simkit.graph.services import Reply, ServiceServer
from simkit.msgs import DeserializationError, service_class

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode


class ServiceRequests:
    """Offers and calls services for one node."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._servers: EndpointTable[ServiceServer] = EndpointTable(
            itertools.count(1), node.servers
        )
        self._calls: dict[int, tuple[Reply, Any]] = {}
        self._call_numbers = itertools.count(1)
        self.asked: dict[Op, Callable[[bytes], Any]] = {Op.OFFER_SERVICE: self._offer}
        """What is answered, and how."""
        self.told: dict[Op, Callable[[bytes], None]] = {
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
            node.tell(Op.SERVE, ids, protocol.pack_name(caller), data)
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
            self._node.tell(Op.CALL_RESULT, head, bytes([success]), answer)

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
