"""Finds the field that kept a message from being sent, after the encoder has failed.

Source:
    genpy's `check_type` (Noetic) for the wording, `field points[].positions[] must be float
    type`; here the value that is wrong follows.
"""

from __future__ import annotations

import re
import reprlib
import struct
from collections.abc import Iterator
from typing import Any

from simkit.msgs.definition import HEADER, NUMBER_CODES, TIME_CODES, Definition, Field
from simkit.msgs.digest import definition_of
from simkit.msgs.errors import SerializationError
from simkit.msgs.rostime import Duration, Time


def explain(message: Any, error: Exception) -> SerializationError:
    """The error that names the wrong field of `message`.

    Args:
        message: The message whose encoder failed.
        error: What the encoder raised; its text is used if all fields look right.
    """
    for complaint in _message_complaints(message._definition, message, ""):
        return SerializationError(f"field {complaint}")
    return SerializationError(f"{message._type}: {error}")


def _message_complaints(definition: Definition, message: Any, prefix: str) -> Iterator[str]:
    for field in definition.fields:
        value = getattr(message, field.attribute, None)
        if field.is_array:
            yield from _array_complaints(field, value, prefix + field.attribute)
        else:
            yield from _value_complaints(field, value, prefix + field.attribute)


def _array_complaints(field: Field, values: Any, name: str) -> Iterator[str]:
    if field.is_octets and isinstance(values, (bytes, bytearray, memoryview)):
        pass
    elif isinstance(values, str) or not hasattr(values, "__len__"):
        yield f"{name} must be a list or tuple type{_but(values)}"
    elif field.is_octets and not isinstance(values, (list, tuple)):
        yield f"{name} must be bytes, a list or a tuple{_but(values)}"
    else:
        for value in values:
            yield from _value_complaints(field, value, f"{name}[]")
    if field.length is not None and len(values) != field.length:
        yield f"{name} must have {field.length} elements, not {len(values)}"


def _value_complaints(field: Field, value: Any, name: str) -> Iterator[str]:
    """What is wrong with one value (of an array: one element) of a field."""
    if field.base in NUMBER_CODES:
        yield from _number_complaints(field.base, value, name)
    elif field.base in TIME_CODES:
        yield from _time_complaints(field.base, value, name)
    elif field.base == "string":
        yield from _string_complaints(value, name)
    else:
        yield from _nested_complaints(field.base, value, name)


def _number_complaints(base: str, value: Any, name: str) -> Iterator[str]:
    try:
        struct.pack("<" + NUMBER_CODES[base], value)
        return
    except (struct.error, TypeError, ValueError, OverflowError, AttributeError):
        is_integer = hasattr(value, "__index__")
    if base == "bool":
        yield f"{name} is not a bool{_but(value)}"
    elif base.startswith("float"):
        kind = f"exceeds specified width [{base}]" if _is_number(value) else "must be float type"
        yield f"{name} {kind}{_but(value)}{_point_instead_of_comma(value)}"
    elif (base.startswith("u") or base == "char") and not (is_integer and value >= 0):
        yield f"{name} must be unsigned integer type{_but(value)}"
    elif not is_integer:
        yield f"{name} must be an integer type{_but(value)}"
    else:
        yield f"{name} exceeds specified width [{base}]{_but(value)}"


def _point_instead_of_comma(value: Any) -> str:
    has_comma = isinstance(value, str) and re.fullmatch(r"[-+]?\d+,\d+", value)
    return f"; write a decimal point, {value.replace(',', '.')}" if has_comma else ""


def _is_number(value: Any) -> bool:
    return hasattr(value, "__float__") or hasattr(value, "__index__")


def _time_complaints(base: str, value: Any, name: str) -> Iterator[str]:
    if not (hasattr(value, "secs") and hasattr(value, "nsecs")):
        wanted = Time if base == "time" else Duration
        yield f"{name} must be of type {wanted.__name__}{_but(value)}"
        return
    number = "uint32" if base == "time" else "int32"
    for part in ("secs", "nsecs"):
        yield from _number_complaints(number, getattr(value, part), f"{name}.{part}")


def _string_complaints(value: Any, name: str) -> Iterator[str]:
    if not isinstance(value, str):
        hint = "; decode() makes a str of bytes" if isinstance(value, bytes) else ""
        yield f"{name} must be of type str{_but(value)}{hint}"
        return
    try:
        value.encode()
    except UnicodeEncodeError:
        yield f"{name} cannot be written as UTF-8: {reprlib.repr(value)}"


def _nested_complaints(base: str, value: Any, name: str) -> Iterator[str]:
    definition = definition_of(base)
    if all(hasattr(value, field.attribute) for field in definition.fields):
        yield from _message_complaints(definition, value, f"{name}.")
    elif base == HEADER:
        yield f"{name} must be a Header{_but(value)}"
    else:
        yield f"{name} must be of type [{base}]{_but(value)}"


def _but(value: Any) -> str:
    """`, not float: 1.5`, or the type alone where a message would fill the screen."""
    kind = getattr(value, "_type", None) or type(value).__name__
    shown = f": {reprlib.repr(value)}" if isinstance(value, (str, bytes, int, float)) else ""
    return f", not {kind}{shown}"
