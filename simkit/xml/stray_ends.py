"""End tags that close nothing, and what went wrong before them."""

from __future__ import annotations

import re

from simkit.xml.document import FaultKind, Span
from simkit.xml.letters import WHITE, short
from simkit.xml.open_elements import OpenElements
from simkit.xml.source import Source
from simkit.xml.tokens import EndTag, StartTag


class StrayEnds:
    """Notes end tags that close nothing.

    Args:
        source: The text.
        open_elements: The elements that are open at the time of each question.
    """

    def __init__(self, source: Source, open_elements: OpenElements) -> None:
        self.closed_by: dict[str, StartTag | EndTag] = {}
        """Of each name the last tag so far that closed an element, `<name/>` or `</name>`."""
        self._source = source
        self._open = open_elements

    def note(self, tag: EndTag) -> None:
        """Note that `tag` closes nothing, or rather the slip before it from which that follows."""
        before = self.closed_by.get(tag.name)
        if self._source.is_full or not tag.name or self._bare_start_tag(tag):
            return
        if isinstance(before, StartTag) and self._is_sibling(before):
            self._closed_by_slash(tag, before)
        elif isinstance(before, EndTag) and not self._source.text[before.end : tag.at].strip(WHITE):
            self._second(tag, before)
        else:
            self._stray(tag)

    def _bare_start_tag(self, tag: EndTag) -> bool:
        """Whether the start tag stands there as text, without its `<`; if so that is the fault."""
        top = self._open.top
        bare = re.compile(rf"(?<![-.:\w]){re.escape(tag.name)}(?:[ \t\n][^<>]*+)?>")
        found = None if top is None else top.find_in_text(bare, self._source.text)
        if found is not None:
            self._source.fault(
                FaultKind.MALFORMED_TAG,
                *found.span(),
                what=f"{short(found[0])} is text, since no < stands before it",
                remedy=f"Write <{short(found[0])}",
                other=self._source.span(tag.at, tag.end),
            )
        return found is not None

    def _is_sibling(self, before: StartTag) -> bool:
        """Whether the element of a start tag stands in what is open here."""
        top = self._open.top
        return top is not None and before.at > top.tag.at

    def _closed_by_slash(self, tag: EndTag, before: StartTag) -> None:
        name, span = short(tag.name), self._source.span(before.at, before.at + len(before.name))
        self._fault(
            tag,
            what=f"</{name}> closes nothing: <{name}/> in line {span.line} is closed by its own /",
            remedy=f"Delete the / at the end of that tag if its element ends here, or else this </{name}>",
            other=span,
        )

    def _second(self, tag: EndTag, before: EndTag) -> None:
        self._fault(
            tag,
            what=f"</{short(tag.name)}> stands here a second time; its element is closed already",
            remedy=f"Delete this second </{short(tag.name)}>",
            other=self._source.span(before.at, before.end),
        )

    def _stray(self, tag: EndTag) -> None:
        name = short(tag.name)
        self._fault(
            tag,
            what=f"</{name}> closes nothing: no <{name}> is open here",
            remedy=f"Delete it, or write <{name}> where the element is to begin.",
        )

    def _fault(self, tag: EndTag, *, what: str, remedy: str, other: Span | None = None) -> None:
        self._source.fault(
            FaultKind.STRAY_END, tag.at, tag.end, what=what, remedy=remedy, other=other
        )
