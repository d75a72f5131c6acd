"""Generates, for a message type, the Python function that turns a message into bytes.

Neighbouring fields of fixed size are packed by one call, through all nested messages. For
geometry_msgs/TransformStamped the function reads:

    def encode(m):
        v1 = m.header
        v2 = v1.stamp
        v3 = v1.frame_id.encode()
        ...
        return b"".join([p1(v1.seq, v2.secs, v2.nsecs, len(v3)), v3, ...])
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Callable, Iterable
from typing import Any

from simkit.msgs.definition import NUMBER_CODES, TIME_CODES, Definition, Field
from simkit.msgs.digest import definition_of
from simkit.msgs.rostime import TVal

Encode = Callable[[Any], bytes]
_IS_LITTLE = sys.byteorder == "little"


def compile_encoder(definition: Definition, encoder_of: Callable[[str], Encode]) -> Encode:
    """The function that encodes messages of a type.

    It checks only what costs nothing: a value that cannot be sent makes it raise some
    exception, whose reason `check.explain` then finds.

    Args:
        definition: The type.
        encoder_of: Message type -> its encoder, for the elements of arrays.
    """
    writer = _Writer(encoder_of)
    writer.write_fields(definition, "m")
    source = writer.source()
    exec(compile(source, f"<encoder of {definition.type}>", "exec"), writer.names)
    encode: Encode = writer.names["encode"]
    return encode


class _Writer:
    """Collects the statements of one encoder and the pieces that it joins."""

    def __init__(self, encoder_of: Callable[[str], Encode]) -> None:
        self.encoder_of = encoder_of
        self.names: dict[str, Any] = {
            "numbers": _numbers,
            "octets": _octets,
            "strings": _strings,
            "times": _times,
            "sized": _sized,
        }
        self._statements: list[str] = []
        self._pieces: list[str] = []
        self._codes: list[str] = []  # the run of fixed fields that is being collected
        self._values: list[str] = []
        self._count = 0

    def source(self) -> str:
        """The source of the function `encode`."""
        self._end_run()
        result = f'b"".join([{", ".join(self._pieces)}])'
        if len(self._pieces) == 1:
            result = self._pieces[0]
        lines = "".join(f"    {line}\n" for line in (*self._statements, f"return {result}"))
        return f"def encode(m):\n{lines}"

    def write_fields(self, definition: Definition, owner: str) -> None:
        """Write the fields of the message that the expression `owner` names."""
        for field in definition.fields:
            value = f"{owner}.{field.attribute}"
            if field.is_array:
                self._write_array(field, value)
            else:
                self._write_single(field, value)

    def _write_single(self, field: Field, value: str) -> None:
        if field.base in NUMBER_CODES:
            self._add_to_run(NUMBER_CODES[field.base], value)
        elif field.base in TIME_CODES:
            time = self._variable(value)
            self._add_to_run(2 * TIME_CODES[field.base], f"{time}.secs, {time}.nsecs")
        elif field.base == "string":
            self._add_framed(self._variable(f"{value}.encode()"))
        else:
            self.write_fields(definition_of(field.base), self._variable(value))

    def _write_array(self, field: Field, value: str) -> None:
        if field.is_octets:
            self._write_octets(field, value)
            return
        array = self._variable(value if field.length is None else f"sized({value}, {field.length})")
        if field.base in NUMBER_CODES and field.length is not None:
            self._add_to_run(f"{field.length}{NUMBER_CODES[field.base]}", f"*{array}")
            return
        if field.length is None:
            self._add_to_run("I", f"len({array})")
        self._add_piece(self._elements(field, array))

    def _elements(self, field: Field, array: str) -> str:
        """Expression of the bytes of all elements."""
        if field.base in NUMBER_CODES:
            return f'numbers("{NUMBER_CODES[field.base]}", {array})'
        if field.base in TIME_CODES:
            return f'times("<{2 * TIME_CODES[field.base]}", {array})'
        if field.base == "string":
            return f"strings({array})"
        encode = self._name("e", self.encoder_of(field.base))
        return f'b"".join(map({encode}, {array}))'

    def _write_octets(self, field: Field, value: str) -> None:
        if field.length is None:
            self._add_framed(self._variable(f"octets({value})"))
        else:
            self._add_piece(f"sized(octets({value}), {field.length})")

    def _add_framed(self, content: str) -> None:
        self._add_to_run("I", f"len({content})")
        self._add_piece(content)

    def _add_to_run(self, code: str, value: str) -> None:
        self._codes.append(code)
        self._values.append(value)

    def _add_piece(self, expression: str) -> None:
        self._end_run()
        self._pieces.append(expression)

    def _end_run(self) -> None:
        if self._codes:
            pack = self._name("p", struct.Struct("<" + "".join(self._codes)).pack)
            self._pieces.append(f"{pack}({', '.join(self._values)})")
            self._codes, self._values = [], []

    def _variable(self, expression: str) -> str:
        self._count += 1
        self._statements.append(f"v{self._count} = {expression}")
        return f"v{self._count}"

    def _name(self, prefix: str, value: object) -> str:
        self._count += 1
        self.names[f"{prefix}{self._count}"] = value
        return f"{prefix}{self._count}"


def _octets(value: Any) -> bytes:
    # `bytes(5)` would be five zeros, and `bytes(array)` the memory of a numpy array.
    if isinstance(value, (bytes, bytearray, memoryview, list, tuple)):
        return bytes(value)
    raise TypeError(f"{type(value).__name__} is not bytes")


def _sized(value: Any, length: int) -> Any:
    if len(value) != length:
        raise ValueError(f"{len(value)} elements instead of {length}")
    return value


def _numbers(code: str, values: Any) -> bytes:
    # The memory of a numpy array of just this type is what is sent.
    if _IS_LITTLE and hasattr(values, "dtype"):
        memory = memoryview(values)
        if memory.format == code and memory.ndim == 1 and memory.c_contiguous:
            return memory.tobytes()
    return struct.pack(f"<{len(values)}{code}", *values)


def _strings(values: Iterable[str]) -> bytes:
    if isinstance(values, str):
        raise TypeError("a string is not a list of strings")
    encoded = [value.encode() for value in values]
    return b"".join([struct.pack("<I", len(text)) + text for text in encoded])


def _times(code: str, values: Iterable[TVal]) -> bytes:
    return b"".join([struct.pack(code, value.secs, value.nsecs) for value in values])
