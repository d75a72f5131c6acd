"""What publishers, subscriptions and service servers share: they end once, and their owner is notified."""

from __future__ import annotations

from collections.abc import Callable
from typing import Self, TypeVar

EndpointT = TypeVar("EndpointT", bound="Endpoint")


class Endpoint:
    """One end of a node's connection to the graph; open until it is unregistered."""

    def __init__(self, node_name: str) -> None:
        self.node_name = node_name
        self.closed = False
        self._on_close: list[Callable[[], None]] = []

    def when_closed(self, callback: Callable[[], None]) -> Self:
        """Call back once, when this endpoint ends."""
        self._on_close.append(callback)
        return self

    def unregister(self) -> None:
        """Leave the graph; harmless when it has left already."""
        if self.closed:
            return
        self.closed = True
        self._leave()
        for callback in self._on_close:
            callback()

    def _leave(self) -> None:
        raise NotImplementedError


def keep_open_ones(endpoint: EndpointT, endpoints: list[EndpointT]) -> EndpointT:
    """Add an endpoint to a node's list, for as long as it is open."""
    endpoints.append(endpoint)
    endpoint.when_closed(lambda: endpoints.remove(endpoint))
    return endpoint
