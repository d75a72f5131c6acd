"""What `rostopic echo` and `print` show of a message: YAML, one field a line; and what `rosmsg show` shows of a type.

Source:
    genpy's `strify_message` (Noetic): nested messages indented by two, `nsecs` right-aligned
    to nine columns, arrays of numbers on one line, of strings and of messages as a list.
"""

from __future__ import annotations

import re
from typing import Any

from simkit.msgs.catalog import service_definition_texts
from simkit.msgs.definition import Definition, parse_definition
from simkit.msgs.digest import definition_of
from simkit.msgs.rostime import TVal

# YAML writes these as they are; anything else is left to PyYAML.
_PLAIN_QUOTED = re.compile(r"[ !#-\[\]-~]{1,70}")
_PLAIN_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*([/.-][A-Za-z0-9_]+)*")
_YAML_WORDS = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null"))


def strify_message(value: Any, indent: str = "") -> str:
    """The text of a message, or of a value of a field.

    Args:
        value: A message, time, string, number, or list of them.
        indent: Put before each line; unless empty, a value of several lines begins with a new
            line, to stand behind `name: `.
    """
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, TVal):
        return f"\n{indent}secs: {value.secs}\n{indent}nsecs: {value.nsecs:9d}"
    if isinstance(value, (list, tuple)):
        return _list_text(value, indent)
    if hasattr(value, "_slot_types"):
        return _message_text(value, indent)
    return str(value)


def _message_text(message: Any, indent: str) -> str:
    lines = []
    for name, kind in zip(message.__slots__, message._slot_types, strict=True):
        value = getattr(message, name)
        if isinstance(value, bytes) and "uint8[" in kind:
            value = list(value)
        lines.append(f"{indent}{name}: {strify_message(value, indent + '  ')}")
    return ("\n" if indent else "") + "\n".join(lines)


def _list_text(values: list[Any] | tuple[Any, ...], indent: str) -> str:
    if not values:
        return "[]"
    if isinstance(values[0], (bool, int)):
        return str(list(values))
    if isinstance(values[0], float):
        return str([float(value) for value in values])  # a numpy float prints its type
    if isinstance(values[0], str):
        return "".join(f"\n{indent}{line}" for line in _string_list(values))
    items = (f"{indent}- {strify_message(value, indent + '  ')}" for value in values)
    return "\n" + "\n".join(items)


def _quoted(text: str) -> str:
    if not text:
        return "''"
    if _PLAIN_QUOTED.fullmatch(text):
        return f'"{text}"'
    import yaml  # 20 ms that few messages need

    return str(yaml.dump(text, default_style='"')).rstrip("\n")


def _string_list(values: list[Any] | tuple[Any, ...]) -> list[str]:
    """Lines of a YAML list of strings."""
    if all(_is_plain(value) for value in values):
        return [f"- {value}" for value in values]
    import yaml

    return str(yaml.dump(list(values))).rstrip("\n").splitlines()


def _is_plain(text: object) -> bool:
    """Whether YAML needs no quotes around the text."""
    return (
        isinstance(text, str)
        and len(text) <= 70
        and _PLAIN_NAME.fullmatch(text) is not None
        and text.lower() not in _YAML_WORDS
    )


def message_text(message_type: str) -> str:
    """The fields of a message, one a line.

    Raises:
        UnknownNameError: There is no such message type.
    """
    return _text(definition_of(message_type), "")


def service_text(service_type: str) -> str:
    """The fields of a request and of its response, `---` between them.

    Raises:
        UnknownNameError: There is no such service type.
    """
    request, response = (
        _text(parse_definition(text, service_type), "")
        for text in service_definition_texts(service_type)
    )
    return f"{request}---\n{response}"


def _text(definition: Definition, indent: str) -> str:
    lines = [f"{indent}{c.base} {c.name}={c.text}\n" for c in definition.constants]
    for field in definition.fields:
        lines.append(f"{indent}{field.type} {field.name}\n")
        if field.is_message:
            lines.append(_text(definition_of(field.base), indent + "  "))
    return "".join(lines)
