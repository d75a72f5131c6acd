"""Graph side: what a script's process asks of the parameter server."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.graph.process import protocol
from simkit.graph.process.protocol import Op

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode

MAX_SET = 64 * 1024 * 1024
"""How much a script may set in parameters over its life [bytes of JSON]."""


class ParameterRequests:
    """Reads and sets parameters for one node."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._size_set = 0
        self.asked: dict[Op, Callable[[bytes], Any]] = {Op.PARAM: self._param}
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
