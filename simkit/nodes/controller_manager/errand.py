"""An errand: a program that waits for things, written as if it had time of its own.

def errand(self):
    yield 0.1                                     # virtual time passes
    answer = yield Call("/spawn", "turtlesim/Spawn", {"x": 1.0})
"""

from __future__ import annotations

from collections.abc import Generator, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from simkit.graph import Node, ServiceFailed
from simkit.msgs import service_class


@dataclass(frozen=True, slots=True, kw_only=True)
class Call:
    """A call of a service."""

    service: str
    """Its resolved name."""
    type_name: str
    """Its type."""
    fields: Mapping[str, Any] = field(default_factory=dict)
    """Of the request."""


Errand: TypeAlias = Generator[float | Call, Any, None]
"""Yields a time to wait [s], or a call; a call gives its response, or raises `ServiceFailed`."""


def run(node: Node, errand: Errand, *, after_shutdown: bool = False) -> None:
    """Begin an errand; it goes on while its node lives.

    Args:
        node: Whose errand it is.
        errand: What is to be done.
        after_shutdown: Whether it goes on when the node has left, without waiting.
    """

    def go_on(value: Any = None, error: ServiceFailed | None = None) -> None:
        if not (node.alive or after_shutdown):
            errand.close()
            return
        try:
            wish = errand.send(value) if error is None else errand.throw(error)
        except StopIteration:
            return
        if isinstance(wish, Call):
            _call(node, wish, go_on)
        else:
            executor = node.graph.executor
            executor.call_at(executor.now_ns + round(wish * 1e9), go_on)

    node.graph.executor.call_soon(go_on)


def _call(node: Node, call: Call, go_on: Any) -> None:
    kind: Any = service_class(call.type_name)

    def take(is_good: bool, data: bytes) -> None:
        if is_good:
            go_on(kind._response_class.from_bytes(data))
        else:
            go_on(
                error=ServiceFailed(f"service [{call.service}] responded with an error: {data!r}")
            )

    if call.service not in node.graph.services:
        go_on(error=ServiceFailed(f"service [{call.service}] unavailable"))
        return
    request = kind._request_class(**call.fields)
    node.graph.call_service(call.service, request.to_bytes(), node.name, take)
