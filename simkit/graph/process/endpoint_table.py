"""Graph side: a node's publishers, subscriptions or services, by the numbers under which the node speaks of them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Generic, TypeVar

from simkit.errors import SimkitError
from simkit.graph.endpoint import Endpoint, keep_open_ones
from simkit.graph.process import protocol

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
