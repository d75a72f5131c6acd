"""Fills a message from plain data, as `rostopic pub` and `rosservice call` do.

Source:
    genpy's `fill_message_args` (Noetic) for what is accepted and for the errors. Beyond it,
    whole seconds may be written as floats, `time_from_start: [1.0, 0.0]`: ROS on Python 2 sent
    them, and books of that time write them.
"""

from __future__ import annotations

import copy
from collections.abc import Iterable
from typing import Any, TypeVar

from simkit.errors import near_names
from simkit.msgs.classes import message_class
from simkit.msgs.definition import HEADER, Field
from simkit.msgs.errors import MessageError
from simkit.msgs.message import Message
from simkit.msgs.rostime import Duration, Time, TVal

_M = TypeVar("_M", bound=Message)
_TIMES: dict[str, type[TVal]] = {"time": Time, "duration": Duration}


def fill_message(made: type[_M], value: object, *, now: Time | None = None) -> _M:
    """A new message with the fields that `value` gives.

    Args:
        made: Class of the message.
        value: Field names with values, a list of all fields in order, one value for a message
            of one field, or `None` for all defaults.
        now: What `stamp: now` and `header: auto` stand for; without it they are errors.

    Raises:
        MessageError: A name is not a field, a list has the wrong length, or a value has the
            wrong kind. Types of numbers and strings are checked when the message is sent.
    """
    if value is None:
        value = {}
    elif not isinstance(value, (dict, list, tuple)):
        value = [value]
    if isinstance(value, (list, tuple)) and len(value) == 1 and isinstance(value[0], dict):
        value = value[0]
    message = made()
    _Filler(_words(now)).fill(message, value, "")
    return message


def field_paths(message: Message, prefix: str = "") -> list[str]:
    """Names of all fields, those of nested messages with dots: `linear.x`, `linear.y`."""
    paths: list[str] = []
    for name in message.__slots__:
        value = getattr(message, name)
        if isinstance(value, Message):
            paths += field_paths(value, f"{prefix}{name}.")
        else:
            paths.append(prefix + name)
    return paths


def _words(now: Time | None) -> dict[str, Message | TVal]:
    if now is None:
        return {}
    return {"auto": message_class(HEADER)(stamp=now), "now": now}


class _Filler:
    """Fills messages; `words` are the words that stand for a message or a time."""

    def __init__(self, words: dict[str, Message | TVal]) -> None:
        self._words = words

    def fill(self, message: Message, value: object, prefix: str) -> None:
        """Set the fields of `message`; `prefix` is how errors name it, with a final dot."""
        fields = {field.attribute: field for field in message._definition.fields}
        for name, item in _items(value, list(fields), prefix):
            if item is None:
                item = ""  # as genpy: a YAML key without value is an empty string
            path = prefix + name
            setattr(message, name, self._field_value(fields[name], item, path))

    def _field_value(self, field: Field, value: object, path: str) -> Any:
        if not field.is_array:
            return self._single_value(field, value, path)
        if field.is_octets:
            return value
        if not isinstance(value, (list, tuple)):
            kind = type(value).__name__
            raise MessageError(f"Field [{path}] must be a list or tuple instead of: {kind}")
        if field.length is not None and len(value) != field.length:
            raise MessageError(
                f"Field [{path}] has incorrect number of elements: {len(value)} != {field.length}"
            )
        return [self._single_value(field, item, f"{path}[]") for item in value]

    def _single_value(self, field: Field, value: object, path: str) -> Any:
        if field.is_message:
            if isinstance(value, str):
                return self._meaning(value, path)
            return self._nested(field.base, value, path)
        if field.base in _TIMES:
            if isinstance(value, str):
                return self._meaning(value, path)
            return _time(_TIMES[field.base], value, path)
        return value

    def _nested(self, base: str, value: object, path: str) -> Message:
        if isinstance(value, Message):
            return value
        message = message_class(base)()
        self.fill(message, value, f"{path}.")
        return message

    def _meaning(self, word: str, path: str) -> Any:
        if word not in self._words:
            known = f"; keys: {', '.join(self._words)}" if self._words else ""
            raise MessageError(f"No key named [{word}] for field [{path}]{known}")
        return copy.deepcopy(self._words[word])


def _items(value: object, names: list[str], prefix: str) -> Iterable[tuple[str, object]]:
    """Pairs of field name and value, from a dict or from a list of all fields."""
    if isinstance(value, dict):
        for name in value:
            if name not in names:
                raise MessageError(_unknown_field(str(name), names, prefix))
        return list(value.items())
    if not isinstance(value, (list, tuple)):
        raise MessageError(
            f"invalid msg_args type: {value!r}; field [{prefix.rstrip('.')}] is filled from a "
            f"dict or a list of: {', '.join(names)}"
        )
    if len(value) != len(names):
        problem = "Too many" if len(value) > len(names) else "Not enough"
        raise MessageError(f"{problem} arguments:\n * Given: {list(value)}\n * Expected: {names}")
    return list(zip(names, value, strict=True))


def _unknown_field(name: str, names: list[str], prefix: str) -> str:
    near = near_names(name, names)
    meant = f"did you mean {near[0]}? " if near else ""
    if name.isdigit():  # of {x: 1,5}
        meant = "a comma begins the next field: write a decimal point, 1.5. "
    return f"No field name [{prefix}{name}]; {meant}Fields: {', '.join(names)}"


def _time(make: type[TVal], value: object, path: str) -> TVal:
    if isinstance(value, TVal):
        return make(value.secs, value.nsecs)
    if isinstance(value, float):
        raise MessageError(
            f"invalid msg_args type: {value!r}; field [{path}] is written as whole numbers, "
            "[secs, nsecs]"
        )
    parts: dict[str, object] = {"secs": 0, "nsecs": 0}
    if isinstance(value, int):
        parts["nsecs"] = value
    else:
        parts.update(_items(value, list(parts), f"{path}."))
    secs, nsecs = (_whole(part, f"{path}.{name}") for name, part in parts.items())
    try:
        return make(secs, nsecs)
    except TypeError as error:
        raise MessageError(f"Field [{path}]: {error}") from None


def _whole(value: object, path: str) -> int:
    if isinstance(value, int) or (isinstance(value, float) and value.is_integer()):
        return int(value)
    raise MessageError(f"Field [{path}] must be a whole number, not {value!r}")
