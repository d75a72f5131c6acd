"""MD5 sums of types, which tell two sides of a connection that they mean the same message.

Source:
    genmsg's `gentools`: constants first, comments and packages gone, a nested message replaced
    by its own sum; a service is the sum over its two texts.
"""

from __future__ import annotations

from functools import cache

from simkit.msgs.catalog import message_definition_text
from simkit.msgs.definition import Definition, Field, parse_definition

_SEPARATOR = "=" * 80


@cache
def definition_of(message_type: str) -> Definition:
    """The definition of a message type.

    Raises:
        UnknownNameError: There is no such message type.
    """
    return parse_definition(message_definition_text(message_type), message_type)


def message_md5(definition: Definition) -> str:
    """MD5 sum of a message, 32 hexadecimal digits."""
    return _md5(_digest_text(definition))


def service_md5(request: Definition, response: Definition) -> str:
    """MD5 sum of a service, 32 hexadecimal digits."""
    return _md5(_digest_text(request) + _digest_text(response))


def full_text(definition: Definition) -> str:
    """The text of the definition, followed by those of all messages in it."""
    parts = [definition.text]
    for name in _dependencies(definition):
        parts.append(f"{_SEPARATOR}\nMSG: {name}\n{definition_of(name).text}")
    return "\n".join(parts)


def _md5(text: str) -> str:
    from hashlib import md5  # loads a crypto library: only when a class is made

    return md5(text.encode(), usedforsecurity=False).hexdigest()


def _digest_text(definition: Definition) -> str:
    constants = [f"{c.base} {c.name}={c.text}" for c in definition.constants]
    return "\n".join((*constants, *map(_field_text, definition.fields)))


def _field_text(field: Field) -> str:
    if field.is_message:
        return f"{message_md5(definition_of(field.base))} {field.name}"
    return f"{field.type} {field.name}"


def _dependencies(definition: Definition) -> list[str]:
    """Types of the nested messages at any depth, each once, outer ones first."""
    found: dict[str, None] = {}
    for field in definition.fields:
        if field.is_message and field.base not in found:
            found[field.base] = None
            found.update(dict.fromkeys(_dependencies(definition_of(field.base))))
    return list(found)
