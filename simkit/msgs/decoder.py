"""Generates, for a message type, the Python function that reads a message from bytes.

Neighbouring fields of fixed size are unpacked by one call, straight into the attributes. No
length in the bytes is believed before it is compared with the bytes that are left, so that the
work is bounded by their number. For geometry_msgs/PointStamped the function reads:

    def decode(b, p, end):
        m = new(c1)
        v3 = m.header = new(c2)
        v5 = v3.stamp = new(c4)
        v3.seq, v5.secs, v5.nsecs, n6, = u7(b, p); p += 16
        if not 0 <= v5.nsecs < 1000000000: v5.canon()
        q = p + n6
        if q > end: short(q - p, end - p)
        ...
        return m, p
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any, NoReturn

from simkit.msgs.definition import NUMBER_CODES, TIME_CODES, Definition, Field
from simkit.msgs.digest import definition_of
from simkit.msgs.errors import DeserializationError
from simkit.msgs.rostime import NSEC_PER_SEC, Duration, Time, TVal

Decode = Callable[[bytes, int, int], tuple[Any, int]]

_TIME_CLASSES: dict[str, type[TVal]] = {"time": Time, "duration": Duration}


def compile_decoder(
    made: type[Any], *, class_of: Callable[[str], type], decoder_of: Callable[[str], Decode]
) -> Decode:
    """The function that decodes one message.

    It takes the bytes, where to begin and where they end, and returns the message and where it
    ended. It raises `DeserializationError` or `struct.error`.

    Args:
        made: Class of the message, with its `_definition`.
        class_of: Message type -> its class, for nested messages.
        decoder_of: Message type -> its decoder, for the elements of arrays.
    """
    writer = _Writer(class_of, decoder_of)
    writer.write_message(made)
    source = writer.source()
    exec(compile(source, f"<decoder of {made._definition.type}>", "exec"), writer.names)
    decode: Decode = writer.names["decode"]
    return decode


class _Writer:
    """Collects the statements of one decoder."""

    def __init__(
        self, class_of: Callable[[str], type], decoder_of: Callable[[str], Decode]
    ) -> None:
        self.class_of = class_of
        self.decoder_of = decoder_of
        self.names: dict[str, Any] = {
            "new": object.__new__,
            "unpack_from": struct.unpack_from,
            "short": _short,
            "strings": _strings,
            "times": _times,
        }
        self._statements: list[str] = []
        self._codes: list[str] = []  # the run of fixed fields that is being collected
        self._targets: list[str] = []
        self._after_run: list[str] = []
        self._count = 0

    def source(self) -> str:
        """The source of the function `decode`."""
        self._end_run()
        lines = "".join(f"    {line}\n" for line in (*self._statements, "return m, p"))
        return f"def decode(b, p, end):\n{lines}"

    def write_message(self, made: type[Any]) -> None:
        """Write the reading of a whole message into the variable `m`."""
        self._statements.append(f"m = new({self._name('c', made)})")
        self._write_fields(made._definition, "m")

    def _write_fields(self, definition: Definition, owner: str) -> None:
        for field in definition.fields:
            target = f"{owner}.{field.attribute}"
            if field.is_array:
                self._write_array(field, target)
            else:
                self._write_single(field, target)

    def _write_single(self, field: Field, target: str) -> None:
        if field.base in NUMBER_CODES:
            self._add_to_run(_read_code(field), target)
        elif field.base in TIME_CODES:
            self._write_time(field, target)
        elif field.base == "string":
            self._write_framed(target, 'b[p:q].decode("utf-8", "replace")')
        else:
            nested = self._new_object(self._name("c", self.class_of(field.base)), target)
            self._write_fields(definition_of(field.base), nested)

    def _write_time(self, field: Field, target: str) -> None:
        time = self._new_object(self._name("c", _TIME_CLASSES[field.base]), target)
        self._add_to_run(2 * TIME_CODES[field.base], f"{time}.secs", f"{time}.nsecs")
        self._after_run.append(f"if not 0 <= {time}.nsecs < {NSEC_PER_SEC}: {time}.canon()")

    def _write_framed(self, target: str, expression: str) -> None:
        self._take(self._read_length())
        self._statements += [f"{target} = {expression}", "p = q"]

    def _write_array(self, field: Field, target: str) -> None:
        if field.is_octets and field.length is None:
            self._write_framed(target, "b[p:q]")
        elif field.length is None:
            self._write_elements(field, target, self._read_length())
        else:
            self._end_run()
            self._write_elements(field, target, str(field.length))

    def _write_elements(self, field: Field, target: str, count: str) -> None:
        """Read `count` elements; the run before them has ended."""
        if field.base in NUMBER_CODES:
            self._write_numbers(field, target, count)
            return
        size = smallest_size(field)
        self._statements.append(f"if {count} * {size} > end - p: short({count} * {size}, end - p)")
        if field.is_message:
            self._write_messages(field, target, count)
            return
        read = {"string": "strings(b, p, end, {})"}.get(
            field.base, f'times("{field.base}", b, p, {{}})'
        )
        self._statements.append(f"{target}, p = {read.format(count)}")

    def _write_numbers(self, field: Field, target: str, count: str) -> None:
        code = _read_code(field)
        self._take(f"{count} * {struct.calcsize('<' + code)}")
        numbers = f'unpack_from(f"<{{{count}}}{code}", b, p)'
        if field.is_octets:
            numbers = "b[p:q]"
        elif field.base == "bool":
            numbers = f"list({numbers})"
        self._statements += [f"{target} = {numbers}", "p = q"]

    def _write_messages(self, field: Field, target: str, count: str) -> None:
        decode = self._name("d", self.decoder_of(field.base))
        items = self._variable("i")
        self._statements += [
            f"{target} = {items} = []",
            f"for _ in range({count}):",
            f"    x, p = {decode}(b, p, end)",
            f"    {items}.append(x)",
        ]

    def _read_length(self) -> str:
        """Read a length at the end of the current run; its variable."""
        length = self._variable("n")
        self._add_to_run("I", length)
        self._end_run()
        return length

    def _take(self, size: str) -> None:
        """Set `q` to the end of the next `size` bytes, which must be there."""
        self._statements += [f"q = p + {size}", "if q > end: short(q - p, end - p)"]

    def _add_to_run(self, code: str, *targets: str) -> None:
        self._codes.append(code)
        self._targets += targets

    def _end_run(self) -> None:
        if not self._codes:
            return
        layout = struct.Struct("<" + "".join(self._codes))
        unpack = self._name("u", layout.unpack_from)
        self._statements.append(f"{', '.join(self._targets)}, = {unpack}(b, p); p += {layout.size}")
        self._statements += self._after_run
        self._codes, self._targets, self._after_run = [], [], []

    def _new_object(self, class_name: str, target: str) -> str:
        variable = self._variable("v")
        self._statements.append(f"{variable} = {target} = new({class_name})")
        return variable

    def _variable(self, prefix: str) -> str:
        self._count += 1
        return f"{prefix}{self._count}"

    def _name(self, prefix: str, value: object) -> str:
        name = self._variable(prefix)
        self.names[name] = value
        return name


def smallest_size(field: Field) -> int:
    """Fewest bytes that one value (of an array: one element) of the field can take.

    An element without any bytes (std_msgs/Empty) counts as one: its number must be bounded too.
    """
    if field.base in NUMBER_CODES:
        return struct.calcsize("<" + NUMBER_CODES[field.base])
    if field.base in TIME_CODES:
        return 8
    if field.base == "string":
        return 4
    return max(1, sum(_smallest_total(inner) for inner in definition_of(field.base).fields))


def _smallest_total(field: Field) -> int:
    if not field.is_array:
        return smallest_size(field)
    return 4 if field.length is None else field.length * smallest_size(field)


def _read_code(field: Field) -> str:
    return "?" if field.base == "bool" else NUMBER_CODES[field.base]


def _short(wanted: int, left: int) -> NoReturn:
    raise DeserializationError(f"{wanted} bytes expected, {left} are left")


def _strings(data: bytes, position: int, end: int, count: int) -> tuple[list[str], int]:
    values = []
    for _ in range(count):
        (length,) = struct.unpack_from("<I", data, position)
        position += 4
        if position + length > end:
            _short(length, end - position)
        values.append(data[position : position + length].decode("utf-8", "replace"))
        position += length
    return values, position


def _times(base: str, data: bytes, position: int, count: int) -> tuple[list[TVal], int]:
    end = position + 8 * count
    pairs = struct.iter_unpack("<" + 2 * TIME_CODES[base], data[position:end])
    make = _TIME_CLASSES[base]
    return [make(secs, nsecs) for secs, nsecs in pairs], end
