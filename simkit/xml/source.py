"""The text that is read, with places in it and the faults found so far."""

from __future__ import annotations

from simkit.xml.document import Fault, FaultKind, Lines, Span

MAX_FAULTS = 200
"""Faults that are kept; whoever has that many is not helped by more of them, and reading ends."""


class Source(Lines):
    """A text, the places in it, and what is wrong with it.

    Args:
        text: The text, with newlines as line ends.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.faults: list[Fault] = []
        self.cut_off = False
        """Whether the text ends in the middle of a tag, and a fault says so."""
        self.has_definitions = False
        """Whether a document type defines entities, so that those that we do not know are none of our business."""
        self._next: dict[tuple[str, bool], tuple[int, int]] = {}

    @property
    def is_full(self) -> bool:
        """Whether further faults are not kept."""
        return len(self.faults) >= MAX_FAULTS

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
