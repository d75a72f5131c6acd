"""`rostopic echo`: prints the messages of a topic as they come, as YAML or as rows of numbers.

Source: rostopic's `_str_plot` and `_str_plot_fields` for `-p`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from simkit.commands.command import Write
from simkit.commands.errors import ToolError
from simkit.commands.parser import ArgumentParser
from simkit.commands.topic_programs import TopicWatcher
from simkit.commands.topic_search import Found
from simkit.graph import Node
from simkit.msgs import Message, Time, TVal, strify_message


@dataclass(frozen=True, slots=True, kw_only=True)
class EchoForm:
    """How messages are shown."""

    count: int | None = None
    "So many messages; any number if None."
    most: int | None = None
    "So many at most, and then how to see more; any number if None."
    csv: bool = False
    "Numbers with commas, for a plot."
    arrays: bool = True
    "Show the elements of arrays, not only their number."
    strings: bool = True
    "Show strings, not only their length."


class TopicEcho(TopicWatcher):
    """Prints each message of a topic, or one field of it, until its number is reached.

    Args:
        node: The node that listens.
        words: The topic, perhaps with a field: `/turtle1/pose/x`.
        write: Takes what is printed.
        form: How messages are shown.
        on_done: Called when the number is reached, or something is wrong.

    Attributes:
        printed: So many messages were printed.
    """

    def __init__(
        self,
        node: Node,
        words: str,
        write: Write,
        *,
        form: EchoForm | None = None,
        on_done: Callable[[], None] | None = None,
    ) -> None:
        self._form = form or EchoForm()
        self.printed = 0
        super().__init__(node, words, write, on_done)

    def _listen(self, found: Found) -> None:
        self.node.subscribe(
            found.topic, found.message_class, lambda message: self._echo(found, message)
        )

    def _echo(self, found: Found, message: Message) -> None:
        if self.done:
            return
        try:
            value = found.value(message)
        except ToolError as error:
            self._finish(error)
            return
        self._write(self._csv(value) if self._form.csv else self._yaml(found, value))
        self.printed += 1
        if self.printed == self._form.count:
            self._finish()
        elif self.printed == self._form.most:
            if self._form.count is None:
                self._write(f"({self.printed} messages; -n COUNT shows so many)\n")
            self._finish()

    def _csv(self, value: Any) -> str:
        header = f"{csv_header(value)}\n" if self.printed == 0 else ""
        return f"{header}{csv_row(value, self.node.now())}\n"

    def _yaml(self, found: Found, value: Any) -> str:
        if isinstance(value, bytes) and found.field_type.startswith("uint8["):
            value = list(value)
        return f"{strify_message(self._shown(value))}\n---\n"

    def _shown(self, value: Any) -> Any:
        if self._form.arrays and self._form.strings:
            return value
        return _Outline(value, self._form) if isinstance(value, Message) else value


class _Outline:
    """A message whose arrays or strings are shown by their size."""

    def __init__(self, message: Message, form: EchoForm) -> None:
        self.__slots__ = list(message.__slots__)
        self._slot_types = list(message._slot_types)
        for name, kind in zip(message.__slots__, message._slot_types, strict=True):
            value = getattr(message, name)
            if "[" in kind and not form.arrays:
                base = kind.partition("[")[0]
                value = f"<array type: {base}, length: {len(value)}>"
            elif kind == "string" and not form.strings:
                value = f"<string length: {len(value)}>"
            elif isinstance(value, Message):
                value = _Outline(value, form)
            setattr(self, name, value)


def csv_header(value: Any) -> str:
    """The first line: `%time,field.x,field.y`."""
    return "%time," + ",".join(name for name, _ in _cells("field", value))


def csv_row(value: Any, now: Time) -> str:
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


def start_echo(
    node: Node,
    words: Sequence[str],
    write: Write,
    on_done: Callable[[], None] | None = None,
    *,
    most: int | None = None,
) -> TopicEcho:
    """Begin `rostopic echo [-n COUNT] [-p] [--noarr] [--nostr] /topic[/field]`.

    Args:
        node: The node that listens.
        words: The words after `rostopic echo`.
        write: Takes what is printed.
        on_done: Called when nothing more will be printed.
        most: So many messages at most; any number if None.

    Raises:
        UsageError: The words ask for nothing.
    """
    parser = ArgumentParser("rostopic echo")
    parser.add_argument("-n", dest="count", type=int, help="stop after so many messages")
    parser.add_argument("-p", dest="csv", action="store_true", help="as rows of numbers")
    parser.add_argument("-c", "--clear", action="store_true", help="no effect here")
    parser.add_argument("--noarr", action="store_true", help="arrays by their length")
    parser.add_argument("--nostr", action="store_true", help="strings by their length")
    parser.add_argument("topic")
    found = parser.parse_args(words)
    if found.count is not None and found.count < 1:
        parser.error("COUNT must be at least 1")
    form = EchoForm(
        count=found.count,
        most=most,
        csv=found.csv,
        arrays=not found.noarr,
        strings=not found.nostr,
    )
    return TopicEcho(node, found.topic, write, form=form, on_done=on_done)
