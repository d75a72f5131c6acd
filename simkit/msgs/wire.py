"""The ROS 1 wire format of the built-in types: little endian, no padding, lengths as uint32.

An array of variable length and a string begin with their length; an array of fixed length does
not. A message is its fields, one after the other.
"""

from __future__ import annotations

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
