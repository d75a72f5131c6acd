"""The elements that are open at a place of the text: a stack that knows its names."""

from __future__ import annotations

import re
from collections import Counter

from simkit.xml.document import Element
from simkit.xml.tokens import StartTag, Text

_MAX_TEXTS = 50
_LONGEST_TEXT = 1000


class OpenElement:
    """An element whose end tag is still to come.

    Args:
        tag: Its start tag.
        element: The element; None if it is nested too deep to be kept.
    """

    __slots__ = ("element", "tag", "texts")

    def __init__(self, tag: StartTag, element: Element | None) -> None:
        self.tag = tag
        self.element = element
        self.texts: list[Text] = []
        """The pieces of text directly in it, so far."""

    @property
    def name(self) -> str:
        """Name of the element."""
        return self.tag.name

    @property
    def text(self) -> str:
        """The text directly in it, so far."""
        return "".join(text.value for text in self.texts)

    def find_in_text(self, pattern: re.Pattern[str], source: str) -> re.Match[str] | None:
        """Where a pattern is in the last texts directly in it, as they stand in the file.

        Long texts are passed over: what is looked for is a tag without its `<`, and tags stand around it.
        """
        for text in reversed(self.texts[-_MAX_TEXTS:]):
            is_short = text.end - text.at <= _LONGEST_TEXT
            found = pattern.search(source, text.at, text.end) if is_short else None
            if found is not None:
                return found
        return None


class OpenElements:
    """The open elements, the root first."""

    def __init__(self) -> None:
        self._stack: list[OpenElement] = []
        self._names: Counter[str] = Counter()

    def __len__(self) -> int:
        return len(self._stack)

    @property
    def top(self) -> OpenElement | None:
        """The innermost one."""
        return self._stack[-1] if self._stack else None

    def push(self, element: OpenElement) -> None:
        """Open an element inside of the innermost one."""
        self._stack.append(element)
        self._names[element.name] += 1

    def pop(self) -> OpenElement:
        """Close the innermost one."""
        element = self._stack.pop()
        self._names[element.name] -= 1
        if element.element is not None:
            element.element.text = element.text
        return element

    def inner(self, count: int) -> list[OpenElement]:
        """So many of the innermost ones, the innermost first."""
        return self._stack[: -count - 1 : -1]

    def above(self, name: str) -> int | None:
        """How many elements are open inside of the innermost one of that name; None if none of that name is open."""
        if not self._names[name]:
            return None
        return next(count for count, one in enumerate(reversed(self._stack)) if one.name == name)
