"""Definitions of messages and services as `rosmsg show` prints them.

Source:
    rosmsg's `spec_to_str`: constants, then fields, those of nested messages indented by two.
"""

from __future__ import annotations

from simkit.msgs.catalog import service_definition_texts
from simkit.msgs.definition import Definition, parse_definition
from simkit.msgs.digest import definition_of


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
