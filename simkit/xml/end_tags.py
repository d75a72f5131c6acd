"""What an end tag means that is not the one that is due: a slip of the pen, one too many, or another one forgotten before it.

The tags that follow decide: whoever wrote one wrong tag wrote the others right.
"""

from __future__ import annotations

from collections.abc import Sequence

from simkit.record import Record
from simkit.xml.document import FaultKind
from simkit.xml.letters import short
from simkit.xml.open_elements import OpenElement, OpenElements
from simkit.xml.outlook import Outlook, are_closed_by
from simkit.xml.source import Source
from simkit.xml.spelling import is_near
from simkit.xml.stray_ends import StrayEnds
from simkit.xml.tokens import EndTag, StartTag

_SIGHT = 3
"""Open elements whose end tags must follow to make an end tag one too many."""
_REACH = 8
"""Open elements whose names an end tag is compared with."""


class Verdict(Record):
    """What an end tag does."""

    closes: int
    """How many elements are closed by it, those without an end tag included; 0 if it is one too many."""
    skip: EndTag | None = None
    """An end tag that has no further meaning: it changed places with this one, and `closes` counts its element."""


_STRAY = Verdict(closes=0)


class EndTagJudge:
    """Tells what end tags mean, and notes those that are wrong in themselves.

    Args:
        source: The text.
        outlook: Its tags.
        open_elements: The elements that are open at the time of each question.
    """

    def __init__(self, source: Source, outlook: Outlook, open_elements: OpenElements) -> None:
        self._source = source
        self._outlook = outlook
        self._open = open_elements
        self._stray_ends = StrayEnds(source, open_elements)

    def note_closed(self, tag: StartTag | EndTag) -> None:
        """Remember a tag that closes an element, `<name/>` or `</name>`."""
        self._stray_ends.closed_by[tag.name] = tag

    def judge(self, number: int, tag: EndTag) -> Verdict:
        """What the end tag, token `number`, means here."""
        top = self._open.top
        if top is None:
            return self._stray(tag)
        if not tag.name:
            return Verdict(closes=1)
        above = self._open.above(tag.name)
        if above == 0:
            is_last = (
                len(self._open) > 1 or self._source.is_full or not self._outlook.goes_on(number)
            )
            return Verdict(closes=1) if is_last else self._early_end(tag)
        if self._source.is_full:
            return _STRAY if above is None else Verdict(closes=above + 1)
        coming = self._outlook.coming(number)
        if above is not None:
            return self._of_open_element(tag, above, coming)
        return self._of_none(tag, coming)

    def _of_open_element(self, tag: EndTag, above: int, coming: Sequence[EndTag]) -> Verdict:
        """An element of that name is open, but others are open in it."""
        if are_closed_by(coming, self._open, above + 1):
            return self._stray(tag)
        inner = self._open.inner(1)[0]
        if above == 1 and coming and coming[0].name == inner.name:
            between = self._source.text[tag.end : coming[0].at]
            if not between.strip():
                self._swapped(tag, inner)
                return Verdict(closes=2, skip=coming[0])
        return Verdict(closes=above + 1)

    def _of_none(self, tag: EndTag, coming: Sequence[EndTag]) -> Verdict:
        """No element of that name is open."""
        if are_closed_by(coming, self._open, _SIGHT):
            return self._stray(tag)
        for above, one in enumerate(self._open.inner(_REACH)):
            if is_near(tag.name, one.name):
                self._misspelt(tag, one.tag)
                return Verdict(closes=above + 1)
        inner = self._open.inner(2)
        if len(inner) == 2 and coming and coming[0].name == inner[1].name:
            self._mismatched(tag, inner[0])
            return Verdict(closes=1)
        return self._stray(tag)

    def _misspelt(self, tag: EndTag, start: StartTag) -> None:
        """One of two tags is misspelt: the one whose name stands nowhere else."""
        source, uses = self._source, self._outlook.uses
        start_span = source.span(start.at, start.at + len(start.name))
        end_span = source.span(tag.at, tag.end)
        opened, closed = f"<{short(start.name)}>", f"</{short(tag.name)}>"
        if uses[start.name] == 1 and uses[tag.name] > 1:
            source.fault_at(
                FaultKind.MISMATCHED_TAG,
                start_span,
                what=f"{opened} is closed by {closed} in line {end_span.line}, whose name is another",
                remedy=f"Write <{short(tag.name)}> here.",
                other=end_span,
            )
            return
        remedy = f"Write </{short(start.name)}>"
        if uses[start.name] == uses[tag.name] == 1:
            remedy += f", or <{short(tag.name)}> in line {start_span.line}"
        source.fault_at(
            FaultKind.MISMATCHED_TAG,
            end_span,
            what=f"{closed} is to close {opened} of line {start_span.line}, but its name is another",
            remedy=remedy,
            other=start_span,
        )

    def _mismatched(self, tag: EndTag, one: OpenElement) -> None:
        source, start = self._source, one.tag
        line = source.line_of(start.at)
        source.fault(
            FaultKind.MISMATCHED_TAG,
            tag.at,
            tag.end,
            what=f"</{short(tag.name)}> stands where <{short(start.name)}> of line {line} is to be closed",
            remedy=f"Write </{short(start.name)}>",
            other=source.span(start.at, start.at + len(start.name)),
        )

    def _swapped(self, tag: EndTag, inner: OpenElement) -> None:
        source, start = self._source, inner.tag
        source.fault(
            FaultKind.MISMATCHED_TAG,
            tag.at,
            tag.end,
            what=f"</{short(tag.name)}> stands before </{short(start.name)}>,"
            f" but <{short(start.name)}> was opened last",
            remedy=f"Write </{short(start.name)}> first, and then </{short(tag.name)}>",
            other=source.span(start.at, start.at + len(start.name)),
        )

    def _early_end(self, tag: EndTag) -> Verdict:
        """The end of the root, and then elements and its end again."""
        self._source.fault(
            FaultKind.STRAY_END,
            tag.at,
            tag.end,
            what=f"</{short(tag.name)}> ends the file's root, but more elements and a second"
            f" </{short(tag.name)}> follow",
            remedy=f"Delete this </{short(tag.name)}>",
        )
        return _STRAY

    def _stray(self, tag: EndTag) -> Verdict:
        """An end tag too many."""
        self._stray_ends.note(tag)
        return _STRAY
