"""Messages as rows of numbers: what `rostopic echo -p` prints.

Source:
    rostopic's `_str_plot` and `_str_plot_fields`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from simkit.msgs import Message, Time, TVal


def header(value: Any) -> str:
    """The first line: `%time,field.x,field.y`."""
    return "%time," + ",".join(name for name, _ in _cells("field", value))


def row(value: Any, now: Time) -> str:
    """One line: time [ns] (of the message's header if it has one), and every value."""
    stamped = isinstance(value, Message) and value._has_header
    time = value.header.stamp if stamped else now
    return f"{time.to_nsec()}," + ",".join(text for _, text in _cells("field", value))


def _cells(name: str, value: Any) -> Iterator[tuple[str, str]]:
    """Name and text of each value in a message, in order."""
    if isinstance(value, Message):
        for field in value.__slots__:
            yield from _cells(f"{name}.{field}", getattr(value, field))
    elif isinstance(value, list | tuple | bytes):
        for index, item in enumerate(value):
            yield from _cells(f"{name}{index}", item)
    elif isinstance(value, bool):
        yield name, str(int(value))
    elif isinstance(value, TVal):
        yield name, str(value.to_nsec())
    else:
        yield name, str(value)
