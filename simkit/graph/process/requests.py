"""Graph side: what a script's process asks of the graph, operation by operation.

Topics, services, parameters and rosout each have their own; here each record finds its own, and the node gets its name.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError
from simkit.graph import names
from simkit.graph.log import LogLevel
from simkit.graph.process import protocol
from simkit.graph.process.endpoint_requests import ServiceRequests, TopicRequests
from simkit.graph.process.protocol import Op, ProtocolError

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode

_LAST = (Op.WAIT, Op.ASK, Op.EXIT)


class Requests:
    """Performs the records of one node's frames."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._initialized = False
        self._topics = TopicRequests(node)
        self._services = ServiceRequests(node)
        self._answered: dict[Op, Callable[[bytes], Any]] = {
            Op.INIT_NODE: self._init_node,
            Op.QUERY: self._query,
            **self._topics.answered,
            **self._services.answered,
            **ParameterRequests(node).answered,
        }
        self._noted: dict[Op, Callable[[bytes], None]] = {
            Op.FAULT: lambda body: node.add_fault(protocol.unpack_json(body)),
            **self._topics.noted,
            **self._services.noted,
            **LogRequests(node).noted,
        }

    def abandon_calls(self) -> None:
        """Fail the calls that this node was still to answer."""
        self._services.abandon_calls()

    def perform(self, frame: bytes) -> tuple[Op, bytes]:
        """Do what a frame asks for; its last record says how the node goes on.

        Raises:
            ProtocolError: The frame is not of the protocol.
        """
        for op, body in protocol.records(frame):
            if op in _LAST:
                return op, body
            if op in self._noted:
                self._noted[op](body)
            elif op in self._answered:
                self._answer(op, body)
            else:
                raise ProtocolError(f"{op.name} is not for a node to say")
        raise ProtocolError("a frame has no end")

    def _answer(self, op: Op, body: bytes) -> None:
        try:
            reply = self._answered[op](body)
        except SimkitError as error:
            reply = {"error": str(error)}
        except (KeyError, TypeError, AttributeError, ValueError) as error:
            raise ProtocolError(f"{op.name} lacks something: {error!r}") from error
        self._node.outbox.add_json(Op.REPLY, reply)

    def _init_node(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        node, line = self._node, self._node.command_line
        if self._initialized:
            raise ProtocolError("a process is one node only")
        base = line.node_name or str(request["name"])
        if not names.is_legal_node_name(base):
            return {
                "error": f"init_node: {base!r} is not a node name: letters, digits and _ only, a letter first"
            }
        if request["anonymous"] and line.node_name is None:
            name = names.free_name(names.join(line.namespace, base), node.graph.nodes)
        else:
            name = names.join(line.namespace, base)
        node.take_name(name)
        self._initialized = True
        for key, value in line.private_parameters.items():
            node.graph.params.set(node.resolve("~" + key), value)
        return {"name": node.name, "arguments": list(line.arguments)}

    def _query(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        what, graph = request["what"], self._node.graph
        if what == "topics":
            return {"value": sorted(graph.topic_types(published=True).items())}
        if what == "service":
            name = self._node.resolve(request["name"])
            server = graph.services.get(name)
            return {"value": server.service_class._type if server else None, "name": name}
        if what == "resolve":
            return {"value": self._node.resolve(request["name"])}
        if what == "connections":
            return {"value": self._topics.connections(request["id"])}
        raise ProtocolError(f"{what!r} is no question")


MAX_TEXT = 10_000
"""Longest line that a script may say [characters]."""
MAX_SAID = 64 * 1024 * 1024
"""How much a script may say over its life [characters]."""
OVERHEAD = 200
"""What keeping a line costs besides its text [characters]."""


class LogRequests:
    """Puts on rosout what one node says, as far as it can be kept."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._size_said = 0
        self.noted: dict[Op, Callable[[bytes], None]] = {Op.LOG: self._log}
        """What is done without an answer."""

    def _log(self, body: bytes) -> None:
        try:
            level = LogLevel(body[0])
        except (ValueError, IndexError) as error:
            raise ProtocolError("not a log level") from error
        text = body[1:].decode("utf-8", "replace")[:MAX_TEXT]
        before = self._size_said
        self._size_said += len(text) + OVERHEAD
        if self._size_said <= MAX_SAID:
            self._node.graph.log(self._node.name, level, text)
        elif before <= MAX_SAID:
            warning = "this node logs too much; no more is kept"
            self._node.graph.log(self._node.name, LogLevel.WARN, warning)


MAX_SET = 64 * 1024 * 1024
"""How much a script may set in parameters over its life [bytes of JSON]."""


class ParameterRequests:
    """Reads and sets parameters for one node."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._size_set = 0
        self.answered: dict[Op, Callable[[bytes], Any]] = {Op.PARAM: self._param}
        """What is answered, and how."""

    def _param(self, body: bytes) -> dict[str, Any]:
        request = protocol.unpack_json(body)
        node, do = self._node, request["do"]
        params = node.graph.params
        if do == "names":
            return {"value": params.names()}
        if do == "search":
            return {"value": params.search(node.name, request["name"])}
        name = node.resolve(request["name"])
        if do == "has":
            return {"value": params.has(name)}
        if do == "get":
            return {"value": params.get(name)} if params.has(name) else {"missing": name}
        if sentence := node.permissions.refuse_parameter(name, node.name):
            return node.refuse(sentence)
        if do == "set":
            self._size_set += len(body)
            if self._size_set > MAX_SET:
                return {"error": "this node has set more parameters than it may"}
            params.set(name, request["value"])
        if do == "delete":
            if not params.has(name):
                return {"missing": name}
            params.delete(name)
        return {}
