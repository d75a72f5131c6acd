"""Start and end tags that do not belong together: what is said of them, and what the tree becomes.

Where the tag that is missing belongs is seen from the element around it and from the indentation, and not looked for farther.
"""

from __future__ import annotations

import re
from itertools import islice

from simkit.xml.document import Attribute, Element, FaultKind, Span
from simkit.xml.letters import NAME, SPACE, WHITE, Pattern, excerpt
from simkit.xml.source import Source
from simkit.xml.tags import EndTag, StartTag, Text

_MAX_TEXTS = 50
_LONGEST_TEXT = 1000
_NAMED = 4
_GOES_ON = Pattern(rf"{SPACE}*+{NAME}{SPACE}*+={SPACE}*+(?:\"[^<\"]*+\"|'[^<']*+')[^<>]*+>")


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


def repair_unclosed(source: Source, one: OpenElement, end: EndTag) -> None:
    """Note that an element is not closed before `end`, and move what does not belong into it behind it.

    Args:
        source: The text.
        one: The element.
        end: The end tag of an element that it stands in.
    """
    twin = _twin(one)
    if twin is not None:
        _note_twin(source, one, twin)
    first = _first_outside(source, one)
    start = source.span(one.tag.at, one.tag.at + len(one.name))
    is_told = one.tag.is_broken or twin is not None or _note_early_bracket(source, one)
    is_told = is_told or note_bare_tag(source, one, one.name, start)
    if not is_told:
        _note_unclosed(source, one, end, first)
    _move_out(one, first)


def repair_end_of_file(source: Source, open_elements: list[OpenElement]) -> None:
    """Close all that is open at the end of the file, with one fault for all."""
    if not source.cut_off:
        _note_end_of_file(source, open_elements)
    while open_elements:
        one = open_elements.pop()
        if not source.is_full:
            _move_out(one, _first_outside(source, one))


def _note_twin(source: Source, one: OpenElement, twin: Element) -> None:
    """Note that an element stands in one of its own name, most likely instead of its end tag; and take it away."""
    name, start = excerpt(one.name), source.span(one.tag.at, one.tag.at + len(one.name))
    source.fault_at(
        FaultKind.DOUBLED_TAG,
        twin.span,
        what=f"this opens a second <{name}> inside of <{name}>, and only one of the two is closed",
        remedy=f"Write </{name}> instead if the first one ends here, or else delete this tag.",
        other=start,
    )
    if one.element is None:
        return
    place = next(at for at, child in enumerate(one.element.children) if child is twin)
    one.element.children[place : place + 1] = twin.children
    for child in twin.children:
        child.parent = one.element


def note_bare_tag(source: Source, one: OpenElement, name: str, other: Span) -> bool:
    """Note a tag that stands as text in an element, since its `<` was forgotten; says whether there is one."""
    pattern = re.compile(rf"(?<![-.:\w/])(/?){re.escape(name)}(?:[ \t\n][^<>]*+)?>")
    texts = [text for text in one.texts[-_MAX_TEXTS:] if text.end - text.at <= _LONGEST_TEXT]
    found = (pattern.search(source.text, text.at, text.end) for text in reversed(texts))
    match = next((match for match in found if match is not None), None)
    if match is None:
        return False
    is_end = match[1] or name == one.name
    source.fault(
        FaultKind.MALFORMED_TAG,
        *match.span(),
        what=f"{excerpt(match[0])} is text, since no < stands before it",
        remedy=f"Write </{excerpt(name)}>" if is_end else f"Write <{excerpt(match[0])}",
        other=other,
    )
    return True


def note_misspelt(source: Source, tag: EndTag, start: StartTag) -> None:
    """One of two tags is misspelt: the one whose name stands nowhere else."""
    start_span = source.span(start.at, start.at + len(start.name))
    end_span = source.span(tag.at, tag.end)
    opened, closed = f"<{excerpt(start.name)}>", f"</{excerpt(tag.name)}>"
    is_start_rare, is_end_rare = _is_rare(source, start.name), _is_rare(source, tag.name)
    if is_start_rare and not is_end_rare:
        what = f"{opened} is closed by {closed} in line {end_span.line}, whose name is another"
        remedy = f"Write <{excerpt(tag.name)}> here."
        start_span, end_span = end_span, start_span
    else:
        what = f"{closed} is to close {opened} of line {start_span.line}, but its name is another"
        remedy = f"Write </{excerpt(start.name)}>"
        if is_start_rare and is_end_rare:
            remedy += f", or <{excerpt(tag.name)}> in line {start_span.line}"
    kind = FaultKind.MISMATCHED_TAG
    source.fault_at(kind, end_span, what=what, remedy=remedy, other=start_span)


def _is_rare(source: Source, name: str) -> bool:
    """Whether a name stands in one tag only."""
    tags = re.finditer(rf"</?{re.escape(name)}(?![-.:\w])", source.text)
    return next(islice(tags, 1, None), None) is None


def note_mismatched(source: Source, tag: EndTag, start: StartTag) -> None:
    """Note an end tag where another element is to be closed."""
    line = source.line_of(start.at)
    source.fault(
        FaultKind.MISMATCHED_TAG,
        tag.at,
        tag.end,
        what=f"</{excerpt(tag.name)}> stands where <{excerpt(start.name)}> of line {line} is to be closed",
        remedy=f"Write </{excerpt(start.name)}>",
        other=source.span(start.at, start.at + len(start.name)),
    )


def wrap_loose(source: Source, end: EndTag, one: OpenElement) -> None:
    """Make an element for an end tag that has no start tag: of what is indented deeper than it, just before it."""
    parent, span = one.element, source.span(end.at + 1, end.end)
    if parent is None or not _begins_line(source, span.line, end.at):
        return
    first = len(parent.children)
    while first and _is_deeper(source, parent.children[first - 1], span):
        first -= 1
    loose = parent.children[first:]
    if not loose:
        return
    at = source.text.find(end.name, end.at)
    lost = Element(
        name=end.name, span=source.span(at, at + len(end.name)), children=loose, parent=parent
    )
    parent.children[first:] = [lost]
    for child in loose:
        child.parent = lost


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


def _twin(one: OpenElement) -> Element | None:
    """The first child of the same name, and with the same attributes or none."""
    children = one.element.children if one.element is not None else ()
    return next(
        (child for child in children if child.name == one.name and is_twin(child.attributes, one)),
        None,
    )


def is_twin(attributes: tuple[Attribute, ...], outer: OpenElement) -> bool:
    """Whether an element of the same name as the one it stands in looks as if it were the same once more, or its end."""
    values = [(one.name, one.value) for one in attributes]
    return not values or values == [(one.name, one.value) for one in outer.tag.attributes]


def _note_early_bracket(source: Source, one: OpenElement) -> bool:
    """Note a `>` behind which the attributes of the tag go on; says whether there is one."""
    at = one.tag.end
    if _GOES_ON.match(source.text, at) is None:
        return False
    source.fault(
        FaultKind.MALFORMED_TAG,
        at - 1,
        at,
        what=f"this > ends the tag <{excerpt(one.name)}>, but more attributes follow",
        remedy="Delete this >",
        other=source.span(one.tag.at, one.tag.at + len(one.name)),
    )
    return True


def _note_unclosed(source: Source, one: OpenElement, end: EndTag, first: int | None) -> None:
    tag, name = one.tag, excerpt(one.name)
    span = source.span(end.at, end.end)
    place = f"before </{excerpt(end.name)}> in line {span.line}"
    remedy = f"Write </{name}> {place}."
    if first == 0 or _is_empty(one):
        shown = excerpt(f"<{source.text[tag.at : tag.end - 1].rstrip(WHITE)}") + "/>"
        remedy = f"Write {shown} if nothing stands in it, or else </{name}> {place}."
    elif first is not None and one.element is not None:
        child = one.element.children[first]
        remedy = f"Write </{name}> before <{excerpt(child.name)}> in line {child.span.line}."
    source.fault(
        FaultKind.UNCLOSED,
        tag.at,
        tag.at + len(tag.name),
        what=f"<{name}> is not closed {place}",
        remedy=remedy,
        other=span,
    )


def _note_end_of_file(source: Source, open_elements: list[OpenElement]) -> None:
    inner = open_elements[: -_NAMED - 1 : -1]
    names = ", ".join(f"<{excerpt(one.name)}>" for one in inner)
    more = len(open_elements) - len(inner)
    ends = "".join(f"</{excerpt(one.name)}>" for one in inner) + ("..." if more else "")
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


def _first_outside(source: Source, one: OpenElement) -> int | None:
    """Number of the first child that does not look like one: its line is indented no more than that of the element."""
    element = one.element
    if element is None or element.parent is None or not element.children:
        return None
    first = element.children[0]
    says_something = (
        _starts_line(source, element)
        and _starts_line(source, first)
        and first.span.line > element.span.line
        and element.parent.span.column < element.span.column
    )
    if not says_something:
        return None
    deeper = (_is_deeper(source, child, element.span) for child in element.children)
    return next((number for number, is_deeper in enumerate(deeper) if not is_deeper), None)


def _is_deeper(source: Source, child: Element, span: Span) -> bool:
    """Whether an element is indented more than another tag, or does not begin its line."""
    return child.span.column > span.column or not _starts_line(source, child)


def _starts_line(source: Source, element: Element) -> bool:
    line = source.lines[element.span.line - 1]
    return line[: element.span.column - 1].strip(WHITE) == "<"


def _begins_line(source: Source, line: int, at: int) -> bool:
    return not source.text[source.text.rfind("\n", 0, at) + 1 : at].strip(WHITE) and line > 1
