"""The text of a message definition (.msg), read into fields and constants."""

from __future__ import annotations

import keyword
import re
from dataclasses import dataclass

from simkit.msgs.errors import DefinitionError

INTEGERS = ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64")
NUMBERS = (*INTEGERS, "float32", "float64", "bool", "char", "byte")
BUILTIN_TYPES = frozenset((*NUMBERS, "string", "time", "duration"))
HEADER = "std_msgs/Header"

_FIELD = re.compile(
    r"(?P<base>[A-Za-z][\w/]*)(?P<array>\[(?P<length>\d*)\])?\s+(?P<name>[A-Za-z]\w*)"
)
_CONSTANT = re.compile(r"(?P<base>[a-z]\w*)\s+(?P<name>[A-Za-z]\w*)\s*=(?P<value>.*)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Field:
    """One field of a message."""

    base: str
    "Type of the value or of each element, with its package: `float64`, `geometry_msgs/Point`."
    name: str
    "Name in the definition."
    is_array: bool = False
    "Whether the field holds several values."
    length: int | None = None
    "Number of elements of an array of fixed length."

    @property
    def type(self) -> str:
        """Type as genpy spells it: `float64[36]`, `geometry_msgs/Point[]`."""
        if not self.is_array:
            return self.base
        return f"{self.base}[{'' if self.length is None else self.length}]"

    @property
    def attribute(self) -> str:
        """Name in Python: a reserved word gets an underscore."""
        reserved = keyword.iskeyword(self.name) or self.name == "self"
        return f"{self.name}_" if reserved else self.name

    @property
    def is_message(self) -> bool:
        """Whether the values are messages themselves."""
        return self.base not in BUILTIN_TYPES

    @property
    def is_octets(self) -> bool:
        """Whether the array is held as `bytes`, as genpy holds uint8[] and char[]."""
        return self.is_array and self.base in ("uint8", "char")


@dataclass(frozen=True, slots=True, kw_only=True)
class Constant:
    """A named value that belongs to a message type."""

    base: str
    "Its built-in type."
    name: str
    "Its name."
    text: str
    "The value as written; the MD5 sum is made of this."

    @property
    def value(self) -> str | float | bool:
        """The value in Python."""
        if self.base == "string":
            return self.text
        if self.base in ("float32", "float64"):
            return float(self.text)
        if self.base == "bool":
            return self.text.lower() in ("true", "1")
        return int(self.text)


@dataclass(frozen=True, slots=True, kw_only=True)
class Definition:
    """What a message type consists of."""

    type: str
    "Name with its package, `geometry_msgs/Twist`."
    text: str
    "The definition as written."
    fields: tuple[Field, ...]
    "In the order of the wire and of `rostopic echo`."
    constants: tuple[Constant, ...]
    "In the order of the text."

    @property
    def has_header(self) -> bool:
        """Whether it is stamped: publishers number and `auto` fills such a message."""
        return any(field.type == HEADER and field.name == "header" for field in self.fields)


def parse_definition(text: str, message_type: str) -> Definition:
    """Read a .msg text, or one part of a .srv or .action text.

    Args:
        text: The definition, comments allowed.
        message_type: The type it defines; a name without package is looked up in its package.

    Raises:
        DefinitionError: A line is neither a field nor a constant; the text names the line.
    """
    fields: list[Field] = []
    constants: list[Constant] = []
    for number, written in enumerate(text.splitlines(), start=1):
        line = written.split("#")[0].strip()
        if not line:
            continue
        if match := _CONSTANT.fullmatch(line):
            constants.append(_constant(match, written))
        elif match := _FIELD.fullmatch(line):
            fields.append(_field(match, message_type.split("/")[0]))
        else:
            raise DefinitionError(
                f"{message_type}, line {number}: {written!r} is neither 'type name' "
                "nor 'type NAME=value'"
            )
    return Definition(
        type=message_type, text=text, fields=tuple(fields), constants=tuple(constants)
    )


def _constant(match: re.Match[str], written: str) -> Constant:
    # A string keeps everything after '=': '#' does not begin a comment there.
    text = written.split("=", 1)[1] if match["base"] == "string" else match["value"]
    return Constant(base=match["base"], name=match["name"], text=text.strip())


def _field(match: re.Match[str], package: str) -> Field:
    base = match["base"]
    if base == "Header":
        base = HEADER
    elif base not in BUILTIN_TYPES and "/" not in base:
        base = f"{package}/{base}"
    length = int(match["length"]) if match["length"] else None
    return Field(base=base, name=match["name"], is_array=bool(match["array"]), length=length)


NUMBER_CODES = {
    "bool": "B",
    "byte": "b",
    "char": "B",
    "int8": "b",
    "uint8": "B",
    "int16": "h",
    "uint16": "H",
    "int32": "i",
    "uint32": "I",
    "int64": "q",
    "uint64": "Q",
    "float32": "f",
    "float64": "d",
}
"""Number type -> code of `struct`; a bool is sent as a number, but read with code `?`."""

TIME_CODES = {"time": "I", "duration": "i"}
"""Type -> code of each of its two fields, secs and nsecs."""

MAX_MESSAGE_BYTES = 16 * 1024 * 1024
"""Largest message that is read unless the caller allows more: a full HD picture is 6 MB."""
