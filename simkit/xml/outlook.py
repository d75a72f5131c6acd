"""What tags say about each other: which names are common, and which end tags are still to come."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import islice

from simkit.xml.open_elements import OpenElements
from simkit.xml.spelling import is_near
from simkit.xml.tokens import EndTag, StartTag, Text, Token

_FAR = 600
"""Tokens that are looked at ahead; what is farther away decides nothing."""
_ENOUGH = 6
"""End tags that are looked for."""


class Outlook:
    """All tags of a text, seen from one of them.

    Args:
        tokens: The text.
    """

    def __init__(self, tokens: Sequence[Token]) -> None:
        self._tokens = tokens

    @cached_property
    def uses(self) -> Counter[str]:
        """How often each name stands in a tag, start or end."""
        return Counter(token.name for token in self._tokens if not isinstance(token, Text))

    @cached_property
    def childless(self) -> frozenset[str]:
        """Names of elements that are written `<name/>` here, and never with an end tag."""
        tags = [token for token in self._tokens if not isinstance(token, Text)]
        ended = {tag.name for tag in tags if isinstance(tag, EndTag)}
        return (
            frozenset(tag.name for tag in tags if isinstance(tag, StartTag) and tag.is_closed)
            - ended
        )

    def coming(self, number: int) -> list[EndTag]:
        """The next end tags behind token `number` of elements that are open there."""
        return list(islice(self._coming(number), _ENOUGH))

    def _coming(self, number: int) -> Iterator[EndTag]:
        inside: list[str] = []
        for token in islice(self._tokens, number + 1, number + 1 + _FAR):
            if isinstance(token, StartTag):
                inside += [] if token.is_closed else [token.name]
            elif isinstance(token, EndTag):
                if token.name in inside:
                    while inside.pop() != token.name:
                        pass
                elif inside and is_near(token.name, inside[-1]):
                    inside.pop()
                else:
                    yield token

    def goes_on(self, number: int) -> bool:
        """Whether the end tag `number`, of the root, has elements behind it and then a second one like it."""
        name = next(
            (
                token.name
                for token in self._tokens[number : number + 1]
                if isinstance(token, EndTag)
            ),
            "",
        )
        balance, has_elements = 0, False
        for token in islice(self._tokens, number + 1, None):
            if isinstance(token, StartTag):
                has_elements = True
                balance += token.name == name and not token.is_closed
            elif isinstance(token, EndTag) and token.name == name:
                balance -= 1
                if balance < 0:
                    return has_elements
        return False


def are_closed_by(tags: Sequence[EndTag], open_elements: OpenElements, count: int) -> bool:
    """Whether these end tags close the `count` innermost open elements, one after the other."""
    count = min(count, len(open_elements))
    if len(tags) < count or count > _ENOUGH:
        return False
    return all(
        tag.name == one.name for tag, one in zip(tags, open_elements.inner(count), strict=False)
    )
