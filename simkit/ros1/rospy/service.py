"""Services and their clients."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from simkit.graph.process import client
from simkit.graph.process.client import Refused
from simkit.graph.process.errors import print_traceback
from simkit.graph.process.protocol import Op
from simkit.msgs import DeserializationError, Message, SerializationError

from .core import interrupted, require_init, resolve_name, spin, when_initialized
from .exceptions import ROSException
from .logs import logerr
from .topics import as_message

_POLL_NS = 300_000_000
"""rospy looks for a service every 0.3 s [ns]."""


class ServiceException(Exception):
    """A service call failed."""


class Service:
    """Offers a service.

    Args:
        name: Service name.
        service_class: Service class.
        handler: Takes a request; gives a response, or its fields as list, tuple or dict.
        buff_size: Taken for rospy's sake.
        error_handler: Called with (error, type, value, trace) when the handler raises.
    """

    def __init__(
        self,
        name: str,
        service_class: Any,
        handler: Callable[[Any], Any],
        buff_size: int = 65536,
        error_handler: Callable[..., object] | None = None,
    ) -> None:
        self.name = name
        self.service_class = service_class
        self.handler = handler
        self.error_handler = error_handler
        self._id: int | None = None
        when_initialized(self._register)

    @property
    def resolved_name(self) -> str:
        """Global name of the service."""
        return resolve_name(self.name)

    def spin(self) -> None:
        """As `rospy.spin`."""
        spin()

    def shutdown(self, reason: str = "") -> None:
        """Withdraw the offer."""
        if self._id is not None:
            client.current().withdraw_service(self._id)
            self._id = None

    def _register(self) -> None:
        try:
            self._id = client.current().offer_service(
                self.name, self.service_class._type, self._serve
            )
        except Refused as error:
            raise ROSException(str(error)) from None

    def _serve(self, data: bytes, caller: str) -> tuple[bool, bytes]:
        try:
            request = self.service_class._request_class.from_bytes(data)
        except DeserializationError as error:
            return False, f"cannot read the request: {error}".encode()
        request._connection_header = {"callerid": caller, "service": self.name}
        try:
            return self._answer(self.handler(request))
        except Exception as error:
            return False, self._explain(error)

    def _answer(self, response: Any) -> tuple[bool, bytes]:
        response_class = self.service_class._response_class
        if response is None:
            return False, b"service cannot process request: service handler returned None"
        if not isinstance(response, response_class):
            if isinstance(response, dict):
                response = response_class(**response)
            elif isinstance(response, list | tuple):
                response = response_class(*response)
            else:
                response = response_class(response)
        return True, response.to_bytes()

    def _explain(self, error: Exception) -> bytes:
        stream = io.StringIO()
        print_traceback(error, stream)
        logerr(f"Error processing request: {error}\n{stream.getvalue()}")
        client.current().report_fault(error)
        return f"error processing request: {error}".encode()


class ServiceProxy:
    """Calls a service.

    Args:
        name: Service name.
        service_class: Service class.
        persistent: Taken for rospy's sake.
        headers: Taken for rospy's sake.
    """

    def __init__(
        self, name: str, service_class: Any, persistent: bool = False, headers: object = None
    ) -> None:
        self.name = name
        self.service_class = service_class
        self.request_class = service_class._request_class
        self.response_class = service_class._response_class

    @property
    def resolved_name(self) -> str:
        """Global name of the service."""
        return resolve_name(self.name)

    def wait_for_service(self, timeout: float | None = None) -> None:
        """As `rospy.wait_for_service`."""
        wait_for_service(self.name, timeout)

    def __call__(self, *args: Any, **kwds: Any) -> Any:
        """As `call`."""
        return self.call(*args, **kwds)

    def call(self, *args: Any, **kwds: Any) -> Any:
        """Call the service, and block until it answers.

        Raises:
            ServiceException: The server refused, is gone, or is not there.
        """
        try:
            request: Message = as_message(self.request_class, args, kwds)
            data = request.to_bytes()
        except SerializationError as error:
            raise ServiceException(f"unable to transform request: {error}") from None
        offered = client.current().ask(Op.QUERY, what="service", name=self.name)
        if offered["value"] is None:
            raise ServiceException("service [{}] unavailable".format(offered["name"]))
        success, answer = client.current().call_service(self.name, data)
        if not success:
            raise ServiceException(
                f"service [{offered['name']}] responded with an error: {answer!r}"
            )
        return self.response_class.from_bytes(answer)

    def close(self) -> None:
        """Nothing to close."""


def wait_for_service(service: str, timeout: float | Any | None = None) -> None:
    """Block until a service is offered.

    Raises:
        ROSException: It was not offered within `timeout` [s].
        ROSInterruptException: The node is shut down.
    """
    require_init("rospy.wait_for_service")
    line = client.current()
    seconds = timeout.to_sec() if hasattr(timeout, "to_sec") else timeout
    until = None if seconds is None else line.peek_ns() + round(seconds * 1e9)
    while line.ask(Op.QUERY, what="service", name=service)["value"] is None:
        if line.shutdown_reason is not None:
            raise interrupted()
        if until is not None and line.peek_ns() >= until:
            raise ROSException(
                f"timeout exceeded while waiting for service {resolve_name(service)}"
            )
        next_look = line.peek_ns() + _POLL_NS
        line.sleep_until(next_look if until is None else min(next_look, until))
