"""Services and their clients."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from simkit.graph.process import client
from simkit.graph.process.failure import print_traceback
from simkit.graph.process.node_client import Refused
from simkit.graph.process.protocol import Op
from simkit.msgs import DeserializationError, Duration, Message

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
            response = as_response(self.handler(request), self.service_class._response_class)
            return True, response.to_bytes()
        except ServiceException as error:
            return False, f"service cannot process request: {error}".encode()
        except Exception as error:
            self._report(error)
            return False, f"error processing request: {error}".encode()

    def _report(self, error: Exception) -> None:
        if self.error_handler is not None:
            self.error_handler(error, type(error), error, error.__traceback__)
            return
        stream = io.StringIO()
        print_traceback(error, stream)
        logerr(f"Error processing request: {error}\n{stream.getvalue()}")
        client.current().report_fault(error)


def as_response(value: Any, response_class: Any) -> Any:
    """The response that a handler means by what it returned.

    Raises:
        ServiceException: It means none.
    """
    if isinstance(value, response_class):
        return value
    if value is None:
        raise ServiceException("service handler returned None")
    try:
        if isinstance(value, dict):
            return response_class(**value)
        return response_class(*value) if type(value) in (list, tuple) else response_class(value)
    except (AttributeError, TypeError) as error:
        many = "wrong number of values" if type(value) in (list, tuple) else "invalid value"
        raise ServiceException(f"handler returned {many}: {error}") from None


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
            ROSInterruptException: The node is shut down.
            SerializationError: A field of the request has the wrong type.
        """
        line = client.current()
        request: Message = as_message(self.request_class, args, kwds)
        data = request.to_bytes()
        name = self._find_server()
        success, answer = line.call_service(self.name, data)
        if success:
            return self.response_class.from_bytes(answer)
        if line.shutdown_reason is not None:
            raise interrupted("node shutdown interrupted service call")
        if answer.startswith(b"transport error"):
            raise ServiceException(answer.decode())
        raise ServiceException(f"service [{name}] responded with an error: {answer!r}")

    def _find_server(self) -> str:
        offered = client.current().ask(Op.QUERY, what="service", name=self.name)
        name, kind = str(offered["name"]), offered["value"]
        if kind is None:
            raise ServiceException(f"service [{name}] unavailable")
        if kind != self.service_class._type:
            raise ServiceException(
                f"unable to connect to service: md5sums do not match: {name} is a {kind}, "
                f"not a {self.service_class._type}"
            )
        return name

    def close(self) -> None:
        """Nothing to close."""


def wait_for_service(service: str, timeout: float | Duration | None = None) -> None:
    """Block until a service is offered.

    Raises:
        ROSException: It was not offered within `timeout` [s].
        ROSInterruptException: The node is shut down.
        ValueError: The timeout is zero.
    """
    require_init("rospy.wait_for_service")
    if timeout == 0.0:
        raise ValueError("timeout must be non-zero")
    line = client.current()
    seconds = timeout.to_sec() if isinstance(timeout, Duration) else timeout
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
