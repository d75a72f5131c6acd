"""Patterns that are compiled when they are first needed, and cheaply for texts of plain letters.

A pattern with the names of XML in it takes milliseconds to compile, for its thousands of letters. Most files
have none of them, and most patterns are for faults that most files do not have.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from simkit.xml.letters import ASCII_START, FOREIGN_ASCII, FOREIGN_LETTERS, INNER, START


class Pattern:
    """A regular expression, used as a compiled one is.

    Args:
        pattern: The expression; may hold `NAME`, `NAME_START` and `FOREIGN_LETTERS`.
        flags: As for `re.compile`.
    """

    __slots__ = ("_flags", "_of_any", "_of_ascii", "_pattern")

    def __init__(self, pattern: str, flags: re.RegexFlag = re.NOFLAG) -> None:
        self._pattern = pattern
        self._flags = flags
        self._of_ascii: re.Pattern[str] | None = None
        self._of_any: re.Pattern[str] | None = None

    def match(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).match(text, *span)

    def search(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).search(text, *span)

    def fullmatch(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).fullmatch(text, *span)

    def finditer(self, text: str, *span: int) -> Iterator[re.Match[str]]:
        """As that of a compiled pattern."""
        return self.of(text).finditer(text, *span)

    def of(self, text: str) -> re.Pattern[str]:
        """The compiled pattern for a text; who matches often keeps it."""
        if text.isascii():
            if self._of_ascii is None:
                plain = self._pattern.replace(START, ASCII_START).replace(INNER, "")
                plain = plain.replace(FOREIGN_LETTERS, FOREIGN_ASCII)
                self._of_ascii = re.compile(plain, self._flags)
            return self._of_ascii
        if self._of_any is None:
            self._of_any = re.compile(self._pattern, self._flags)
        return self._of_any
