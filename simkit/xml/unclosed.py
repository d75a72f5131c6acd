"""Elements without an end tag: where it most likely belongs, and what does not belong into them."""

from __future__ import annotations

import re

from simkit.record import Record
from simkit.xml.document import Element, FaultKind, Span
from simkit.xml.letters import NAME, SPACE, WHITE, short
from simkit.xml.open_elements import OpenElement, OpenElements
from simkit.xml.outlook import Outlook
from simkit.xml.pattern import Pattern
from simkit.xml.source import Source
from simkit.xml.tokens import EndTag

_GOES_ON = Pattern(
    rf"{SPACE}*+(?:{NAME}{SPACE}*+={SPACE}*+(?:\"[^<\"]*+\"|'[^<']*+'){SPACE}*+)++/?>"
)
_NAMED = 4


def is_bare_twin(one: OpenElement, outer: OpenElement) -> bool:
    """Whether the tag of `one` was most likely to be the end tag of `outer`, as in `<visual> ... <visual>`."""
    return one.name == outer.name and not one.tag.attributes


def settle_unclosed(
    source: Source, outlook: Outlook, one: OpenElement, end: EndTag, *, is_twin: bool
) -> None:
    """Note that an element is not closed before `end`, and move what does not belong into it behind it.

    Args:
        source: The text.
        outlook: Its tags.
        one: The element.
        end: The end tag of an element that it stands in.
        is_twin: Whether the element was to be an end tag of the one that it stands in; that one is settled next, and
            then the fault is noted.
    """
    if source.is_full:
        return
    if is_twin:
        _move_out(one, 0)
        return
    if _is_doubled(one):
        _settle_doubled(source, one)
        return
    twin = _twin(one)
    first = _first_outside(source, outlook, one) if twin is None else twin + 1
    if not one.tag.is_broken:
        _Note(source, one, end).write(first, twin)
    _move_out(one, first)
    if twin is not None and one.element is not None:
        del one.element.children[twin]


def _is_doubled(one: OpenElement) -> bool:
    """Whether the tag of an element stands once more right behind it, as after a copy of one line."""
    element = one.element
    if element is None or element.parent is None or not element.children:
        return False
    first = element.children[0]
    is_behind_text = element.text_span is not None and element.text_span < first.span
    return not is_behind_text and _written(first) == _written(element)


def _written(element: Element) -> tuple[str, list[tuple[str, str]]]:
    return element.name, [(one.name, one.value) for one in element.attributes]


def _settle_doubled(source: Source, one: OpenElement) -> None:
    """Note that a start tag stands twice, and put what the second one holds in the place of the first."""
    element = one.element
    assert element is not None, "it is doubled"
    assert element.parent is not None, "it is doubled"
    inner, siblings = element.children[0], element.parent.children
    source.fault_at(
        FaultKind.DOUBLED_TAG,
        inner.span,
        what=f"{short(source.text[one.tag.at - 1 : one.tag.end])} stands here a second time, and only one of the two is closed",
        remedy="Delete this second tag.",
        other=element.span,
    )
    _move_out(one, 1)
    place = next(at for at in range(len(siblings) - 1, -1, -1) if siblings[at] is element)
    siblings[place] = inner
    inner.parent = element.parent


def settle_end_of_file(source: Source, outlook: Outlook, open_elements: OpenElements) -> None:
    """Close all that is open at the end of the file, with one fault for all."""
    if not source.cut_off:
        _note_end_of_file(source, open_elements)
    while len(open_elements):
        one = open_elements.pop()
        if not source.is_full:
            _move_out(one, _first_outside(source, outlook, one))


def _twin(one: OpenElement) -> int | None:
    """Number of a child that was to be the end tag: of the same name, and bare, as in `<visual> ... <visual/>`."""
    for number, child in enumerate(one.element.children if one.element is not None else ()):
        if child.name == one.name and not (child.attributes or child.children or child.text_span):
            return number
    return None


class _Note(Record, kw_only=False):
    """What is to be said of an element that is not closed."""

    source: Source
    one: OpenElement
    end: EndTag

    def write(self, first: int | None, twin: int | None) -> None:
        """Note the fault. `first` and `twin` are numbers of children: the first outside, and the one that is an end tag."""
        if twin is not None and self.one.element is not None:
            self._wrong_end_tag(self.one.element.children[twin])
        elif _GOES_ON.match(self.source.text, self.one.tag.end):
            self._early_bracket()
        elif not self._bare_end_tag():
            self._unclosed(first)

    def _wrong_end_tag(self, twin: Element) -> None:
        name = short(self.one.name)
        self._malformed(
            twin.span,
            what=f"this opens another <{name}> inside of <{name}>, which is not closed",
            remedy=f"Write </{name}> instead.",
        )

    def _early_bracket(self) -> None:
        at = self.one.tag.end
        self._malformed(
            self.source.span(at - 1, at),
            what=f"this > ends the tag <{short(self.one.name)}>, but more attributes follow",
            remedy="Delete this >",
        )

    def _bare_end_tag(self) -> bool:
        """Whether `/name>` or `name>` stands somewhere as text; if so that is the fault."""
        bare = re.compile(rf"/?{re.escape(self.one.name)}[ \t]*+>")
        found = self.one.find_in_text(bare, self.source.text)
        if found is not None:
            span = self.source.span(*found.span())
            what = f"{short(found[0])} is text, since no < stands before it"
            self._malformed(span, what=what, remedy=f"Write </{short(self.one.name)}>")
        return found is not None

    def _malformed(self, span: Span, *, what: str, remedy: str) -> None:
        tag = self.one.tag
        other = self.source.span(tag.at, tag.at + len(tag.name))
        other = self.source.span(self.end.at, self.end.end) if other == span else other
        self.source.fault_at(FaultKind.MALFORMED_TAG, span, what=what, remedy=remedy, other=other)

    def _unclosed(self, first: int | None) -> None:
        source, tag, name = self.source, self.one.tag, short(self.one.name)
        end = source.span(self.end.at, self.end.end)
        place = f"before </{short(self.end.name)}> in line {end.line}"
        remedy = f"Write </{name}> {place}."
        if first == 0 or _is_empty(self.one):
            shown = short(f"<{source.text[tag.at : tag.end - 1].rstrip(WHITE)}") + "/>"
            remedy = f"Write {shown} if nothing stands in it, or else </{name}> {place}."
        elif first is not None and self.one.element is not None:
            child = self.one.element.children[first]
            remedy = f"Write </{name}> before <{short(child.name)}> in line {child.span.line}."
        source.fault(
            FaultKind.UNCLOSED,
            tag.at,
            tag.at + len(tag.name),
            what=f"<{name}> is not closed {place}",
            remedy=remedy,
            other=end,
        )


def _note_end_of_file(source: Source, open_elements: OpenElements) -> None:
    inner = open_elements.inner(_NAMED)
    if len(inner) > 1 and is_bare_twin(inner[0], inner[1]):
        name, at = short(inner[0].name), inner[0].tag.at
        source.fault(
            FaultKind.MALFORMED_TAG,
            at,
            at + len(inner[0].name),
            what=f"this opens another <{name}> inside of <{name}>, and the file ends with both open",
            remedy=f"Write </{name}> instead.",
            other=source.span(inner[1].tag.at, inner[1].tag.at + len(name)),
        )
        return
    names = ", ".join(f"<{short(one.name)}>" for one in inner)
    more = len(open_elements) - len(inner)
    ends = "".join(f"</{short(one.name)}>" for one in inner) + ("..." if more else "")
    verb = "is" if len(open_elements) == 1 else "are"
    source.fault(
        FaultKind.UNCLOSED,
        inner[0].tag.at,
        inner[0].tag.at + len(inner[0].name),
        what=f"the file ends, and {names}{f' and {more} more' if more else ''} {verb} not closed",
        remedy=f"Write {ends} at the end of the file.",
    )


def _is_empty(one: OpenElement) -> bool:
    has_children = one.element is not None and bool(one.element.children)
    return not has_children and not one.text.strip(WHITE)


def _first_outside(source: Source, outlook: Outlook, one: OpenElement) -> int | None:
    """Number of the first child that does not look like one: its line is indented no more than that of the element.

    In a file without indentation only this counts: an element that is never written with an end tag has no children.
    """
    element = one.element
    if element is None or element.parent is None or not element.children:
        return None
    if not _is_indented(source, element):
        return 0 if element.name in outlook.childless else None
    for number, child in enumerate(element.children):
        if (
            child.span.line > element.span.line
            and child.span.column <= element.span.column
            and _begins_line(source, child)
        ):
            return number
    return None


def _is_indented(source: Source, element: Element) -> bool:
    """Whether the place of an element in its line says something: it is not that of its parent, or its child's line."""
    parent, first = element.parent, element.children[0]
    if parent is None or not _begins_line(source, element) or not _begins_line(source, first):
        return False
    return first.span.line > element.span.line and parent.span.column < element.span.column


def _begins_line(source: Source, element: Element) -> bool:
    line = source.lines[element.span.line - 1]
    return line[: element.span.column - 1].strip(WHITE) == "<"


def _move_out(one: OpenElement, first: int | None) -> None:
    """Make the children from number `first` on siblings of their parent."""
    element = one.element
    if first is None or element is None or element.parent is None:
        return
    moved = element.children[first:]
    del element.children[first:]
    for child in moved:
        child.parent = element.parent
    element.parent.children.extend(moved)
