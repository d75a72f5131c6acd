"""The text that is read, with places in it and the faults found so far."""

from __future__ import annotations

import bisect
import re

from simkit.xml.document import Fault, FaultKind, Span

MAX_FAULTS = 200
"""Faults that are kept; whoever has that many is not helped by more of them, and reading ends."""


class Source:
    """A text, the place of each of its letters, and what is wrong with it.

    Args:
        text: The text, with newlines as line ends.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.lines = tuple(text.split("\n"))
        self.faults: list[Fault] = []
        self.cut_off = False
        """Whether the text ends in the middle of a tag, and a fault says so."""
        self.has_definitions = False
        """Whether a document type defines entities, so that those that we do not know are none of our business."""
        self._starts = [0, *(found.end() for found in re.finditer("\n", text))]
        self._next: dict[tuple[str, bool], tuple[int, int]] = {}

    @property
    def is_full(self) -> bool:
        """Whether further faults are not kept."""
        return len(self.faults) >= MAX_FAULTS

    def span(self, start: int, end: int) -> Span:
        """The place of a piece of text; of one over several lines its part in the first one."""
        line = bisect.bisect_right(self._starts, start)
        column = start - self._starts[line - 1]
        width = len(self.lines[line - 1])
        if start < end and column + end - start <= width:
            return Span(line, column + 1, end - start)
        column = max(0, min(column, width - 1))
        return Span(line, column + 1, max(1, min(end - start, width - column)))

    def line_of(self, at: int) -> int:
        """The line (from 1) that a letter stands in."""
        return bisect.bisect_right(self._starts, at)

    def find(self, wanted: str, start: int, *, is_ahead: bool = False) -> int:
        """Where a text comes next at or behind `start`; -1 if it does not.

        The last answer for each text is remembered: asking over and over from places further and further on reads the file
        once, however often the answer is the same. Who looks ahead has a memory of his own.
        """
        asked, answer = self._next.get((wanted, is_ahead), (0, -2))
        if answer == -2 or start < asked or 0 <= answer < start:
            answer = self.text.find(wanted, start)
            self._next[wanted, is_ahead] = (start, answer)
        return answer

    def fault(
        self,
        kind: FaultKind,
        start: int,
        end: int,
        *,
        what: str,
        remedy: str,
        other: Span | None = None,
    ) -> None:
        """Note a fault at a piece of the text."""
        self.fault_at(kind, self.span(start, end), what=what, remedy=remedy, other=other)

    def fault_at(
        self, kind: FaultKind, span: Span, *, what: str, remedy: str, other: Span | None = None
    ) -> None:
        """Note a fault at a place; the remedy becomes a sentence with a full stop."""
        if not self.is_full:
            remedy = remedy if remedy.endswith(".") else f"{remedy}."
            self.faults.append(Fault(kind=kind, span=span, what=what, remedy=remedy, other=other))
