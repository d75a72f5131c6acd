"""Services: who answers which, and how a call travels.

An answer may come at once (a built-in node) or later in virtual time (a script), so a call carries the function that takes it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.graph.endpoint import Endpoint
from simkit.msgs import DeserializationError, Message

Reply = Callable[[bool, bytes], None]
"""Takes (success, response in wire format) or (failure, error text in UTF-8)."""
Responder = Callable[[bytes, str, Reply], None]
"""Takes a request in wire format, the caller's node name, and the function that takes the answer."""


class ServiceFailed(SimkitError):
    """A service call failed; the text is what the server says."""


class ServiceServer(Endpoint):
    """A node's offer to answer calls of one service."""

    def __init__(
        self,
        name: str,
        node_name: str,
        service_class: Any,
        respond: Responder,
        withdraw: Callable[[ServiceServer], None],
    ) -> None:
        super().__init__(node_name)
        self.name = name
        self.service_class = service_class
        self.respond = respond
        self._withdraw = withdraw

    def shutdown(self) -> None:
        """Withdraw the offer."""
        self.unregister()

    def _leave(self) -> None:
        self._withdraw(self)


def immediate_responder(service_class: Any, handler: Callable[[Any], Message]) -> Responder:
    """A responder that decodes the request, asks `handler`, and answers within the same instant."""

    def respond(data: bytes, caller: str, reply: Reply) -> None:
        try:
            request = service_class._request_class.from_bytes(data)
            request._connection_header = {"callerid": caller, "type": service_class._type}
            response = handler(request)
        except (ServiceFailed, DeserializationError) as error:
            reply(False, str(error).encode())
            return
        reply(True, response.to_bytes())

    return respond
