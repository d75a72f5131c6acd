"""What a text is made of: start tags, end tags and the text between them, in the order of the file."""

from __future__ import annotations

from typing import NamedTuple

from simkit.xml.document import Attribute


class StartTag(NamedTuple):
    """`<name attribute="value">` or `<name/>`."""

    name: str
    """Name of the element."""
    at: int
    """Where the name stands: index of its first letter."""
    end: int
    """Index behind the tag."""
    attributes: tuple[Attribute, ...]
    """Its attributes, each name once."""
    is_closed: bool
    """Whether it ends with `/>`."""
    is_broken: bool
    """Whether its end is faulty, and a fault says so: it may have been meant to end with `/>`."""


class EndTag(NamedTuple):
    """`</name>`."""

    name: str
    """Name of the element; empty if there is none, which a fault says."""
    at: int
    """Index of its `<`."""
    end: int
    """Index behind the tag."""


class Text(NamedTuple):
    """Text between tags."""

    value: str
    """The text, references replaced."""
    at: int
    """Index of its first letter in the file."""
    end: int
    """Index behind it."""
    is_plain: bool
    """Whether it is just letters: no reference, no CDATA section."""


Token = StartTag | EndTag | Text
