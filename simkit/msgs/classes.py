"""Makes the class of a message or service from its definition, on first request."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import cache, partial
from typing import Any, ClassVar, cast

from simkit.msgs.catalog import service_definition_texts
from simkit.msgs.decoder import Decode, compile_decoder
from simkit.msgs.definition import HEADER, Definition, Field, parse_definition
from simkit.msgs.digest import definition_of, full_text, message_md5, service_md5
from simkit.msgs.encoder import Encode, compile_encoder
from simkit.msgs.message import Message
from simkit.msgs.rostime import Duration, Time

# Two threads must not make two classes of one name.
_LOCK = threading.RLock()


class Service:
    """Base of the service classes: a pair of message classes."""

    _type: ClassVar[str]
    """Name with its package, `turtlesim/Spawn`."""
    _md5sum: ClassVar[str]
    """MD5 sum, equal to that of real ROS."""
    _request_class: ClassVar[type[Message]]
    """Class of the request, `SpawnRequest`."""
    _response_class: ClassVar[type[Message]]
    """Class of the response, `SpawnResponse`."""


def message_class(message_type: str) -> type[Message]:
    """The class of a message type, always the same one.

    Args:
        message_type: Name with its package, `geometry_msgs/Twist`, or `Header`.

    Raises:
        UnknownNameError: There is no such message type.
    """
    with _LOCK:
        return _message_class(HEADER if message_type == "Header" else message_type)


def service_class(service_type: str) -> type[Service]:
    """The class of a service type, always the same one.

    Args:
        service_type: Name with its package, `turtlesim/Spawn`.

    Raises:
        UnknownNameError: There is no such service type.
    """
    with _LOCK:
        return _service_class(service_type)


@cache
def _message_class(message_type: str) -> type[Message]:
    definition = definition_of(message_type)
    package, name = message_type.split("/")
    return _make_class(definition, f"{package}.msg._{name}")


@cache
def _service_class(service_type: str) -> type[Service]:
    request_text, response_text = service_definition_texts(service_type)
    package, name = service_type.split("/")
    module = f"{package}.srv._{name}"
    request = parse_definition(request_text, f"{service_type}Request")
    response = parse_definition(response_text, f"{service_type}Response")
    attributes = {
        "__module__": module,
        "__doc__": f"The service {service_type}.",
        "_type": service_type,
        "_md5sum": service_md5(request, response),
        "_request_class": _make_class(request, module),
        "_response_class": _make_class(response, module),
    }
    return type(name, (Service,), attributes)


def _make_class(definition: Definition, module: str) -> type[Message]:
    defaults = [(field.attribute, _default(field)) for field in definition.fields]
    attributes: dict[str, Any] = {
        constant.name: constant.value for constant in definition.constants
    }
    attributes |= {
        "__module__": module,
        "__doc__": f"The message {definition.type}.",
        "__slots__": [field.attribute for field in definition.fields],
        "_type": definition.type,
        "_md5sum": message_md5(definition),
        "_full_text": full_text(definition),
        "_slot_types": [field.type for field in definition.fields],
        "_has_header": definition.has_header,
        "_definition": definition,
        "_constant_defaults": tuple((n, v) for n, v in defaults if not callable(v)),
        "_fresh_defaults": tuple((n, v) for n, v in defaults if callable(v)),
    }
    made = cast("type[Message]", type(definition.type.split("/")[1], (Message,), attributes))
    # The codec is compiled when it is first needed: many classes only lend their fields.
    made._encode = staticmethod(lambda message: _encoder(made)(message))
    made._decode = staticmethod(lambda *arguments: _decoder(made)(*arguments))
    return made


def _default(field: Field) -> Any:
    """The default of a field, or for a mutable one the function that makes it."""
    if not field.is_array:
        return _value_default(field)
    length = field.length or 0
    if field.is_octets:
        return bytes(length)
    value = _value_default(field)
    if callable(value):
        return partial(_several, value, length)
    return lambda: [value] * length


def _several(make: Callable[[], Any], length: int) -> list[Any]:
    return [make() for _ in range(length)]


def _value_default(field: Field) -> Any:
    if field.is_message:
        return _message_class(field.base)
    special = {"bool": False, "float32": 0.0, "float64": 0.0, "string": ""}
    return {"time": Time, "duration": Duration}.get(field.base, special.get(field.base, 0))


@cache
def _encoder(made: type[Message]) -> Encode:
    encode = compile_encoder(made._definition, lambda name: _encoder(message_class(name)))
    made._encode = staticmethod(encode)
    return encode


@cache
def _decoder(made: type[Message]) -> Decode:
    decode = compile_decoder(
        made, class_of=message_class, decoder_of=lambda name: _decoder(message_class(name))
    )
    made._decode = staticmethod(decode)
    return decode
