"""What is read from an XML text: elements, attributes, and what is wrong with it, each with its place."""

from __future__ import annotations

import enum
import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple


class Span(NamedTuple):
    """A piece of one line."""

    line: int
    """Line, from 1."""
    column: int
    """First letter, from 1, counted in characters."""
    length: int = 1
    """Letters; at least 1, and never beyond the end of the line."""


class Lines:
    """Where the letters of a text stand: its lines.

    Args:
        text: The text, with newlines as line ends.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.lines = tuple(text.split("\n"))
        self._starts = [0, *(found.end() for found in re.finditer("\n", text))]

    def span(self, start: int, end: int) -> Span:
        """The place of a piece of text; of one over several lines its part in the first one."""
        line = bisect_right(self._starts, start)
        column = start - self._starts[line - 1]
        width = len(self.lines[line - 1])
        if start < end and column + end - start <= width:
            return Span(line, column + 1, end - start)
        column = max(0, min(column, width - 1))
        return Span(line, column + 1, max(1, min(end - start, width - column)))

    def line_of(self, at: int) -> int:
        """The line (from 1) that a letter stands in."""
        return bisect_right(self._starts, at)


class FaultKind(enum.Enum):
    """What can be wrong with an XML text."""

    EMPTY = "empty"
    """Nothing in it, or no element."""
    ENCODING = "encoding"
    """Bytes that are not the encoding that is declared (UTF-8 if none is)."""
    DECLARATION = "declaration"
    """Something before `<?xml ... ?>`, which must be the very beginning."""
    MISMATCHED_TAG = "mismatched tag"
    """An end tag that closes another element than the one that is open."""
    STRAY_END = "stray end tag"
    """An end tag, and no element of that name is open."""
    UNCLOSED = "unclosed element"
    """An element without an end tag."""
    DOUBLED_TAG = "doubled tag"
    """A start tag that stands there twice, with one end tag for both."""
    DUPLICATE_ATTRIBUTE = "duplicate attribute"
    """The same attribute twice in one tag; the first one is kept."""
    MALFORMED_TAG = "malformed tag"
    """A tag that is no tag: a missing `>`, `=`, quotation mark or name."""
    LOOSE_ATTRIBUTE = "loose attribute"
    """A value without quotation marks, or no space between two attributes; lenient parsers read it all the same."""
    MARKUP = "bad markup"
    """Something between `<` and `>` that is no tag, or a declaration in the wrong place."""
    BAD_CHARACTER = "bad character"
    """A letter that cannot stand there: `<` or `&` in a value, a control character, `--` in a comment."""
    BAD_REFERENCE = "bad reference"
    """`&#` that begins no number of a letter."""
    ENTITY = "entity"
    """An entity that is not one of the five of XML, or a document type with definitions of its own."""
    CONFLICT = "conflict marker"
    """A line that git leaves where two versions of a text do not fit together."""
    STRAY_TEXT = "stray text"
    """Text outside of the root element."""
    SECOND_ROOT = "second root"
    """An element behind the root element."""
    UNCLOSED_SECTION = "unclosed section"
    """A comment, CDATA section or processing instruction without an end."""
    TOO_DEEP = "too deep"
    """Elements nested beyond all use; what is deeper is left out."""


@dataclass(frozen=True, kw_only=True)
class Fault:
    """One thing that is wrong with the text as XML."""

    kind: FaultKind
    """What kind of fault."""
    span: Span
    """Where it is: the culprit, not the place where a parser noticed."""
    what: str
    """What is wrong, in one sentence without a full stop."""
    remedy: str
    """What would be right."""
    other: Span | None = None
    """A second place that belongs to it, e.g. the start tag that is not closed."""


class Attribute(NamedTuple):
    """One attribute of a start tag."""

    name: str
    """Its name, with a prefix if there is one."""
    value: str
    """Its value, entities replaced, white space as in XML (each newline or tab a space)."""
    written: str
    """Its value with its tabs and newlines, entities replaced: what parsers see that do not normalise it."""
    name_at: int
    """Index of the first letter of its name."""
    value_at: int
    """Index of the first letter of its value."""
    value_end: int
    """Index behind its value."""
    lines: Lines
    """The text that it stands in."""

    @property
    def name_span(self) -> Span:
        """Where its name stands."""
        return self.lines.span(self.name_at, self.name_at + len(self.name))

    @property
    def value_span(self) -> Span:
        """Where its value stands, without the quotation marks; of one over several lines the first one."""
        return self.lines.span(self.value_at, self.value_end)


class Element:
    """One element.

    A plain class, as there are many of them: no record is made as fast, or as small.
    """

    __slots__ = ("attributes", "children", "name", "parent", "span", "text", "text_span")

    def __init__(
        self,
        *,
        name: str,
        span: Span,
        attributes: tuple[Attribute, ...] = (),
        children: list[Element] | None = None,
        text: str = "",
        text_span: Span | None = None,
        parent: Element | None = None,
    ) -> None:
        self.name = name
        """Its name, with a prefix if there is one."""
        self.span = span
        """Where its name stands in the start tag."""
        self.attributes = attributes
        """Its attributes in the order of the text, each name once: of duplicates the first."""
        self.children: list[Element] = [] if children is None else children
        """The elements in it, in the order of the text."""
        self.text = text
        """The text directly in it, without that of its children."""
        self.text_span = text_span
        """Where the first letter of that text that is not white space stands; None if there is none."""
        self.parent = parent
        """The element it stands in; None for a root."""

    def __repr__(self) -> str:
        return f"<Element {self.path} in line {self.span.line}>"

    def attribute(self, name: str) -> Attribute | None:
        """The attribute of that name."""
        return next((one for one in self.attributes if one.name == name), None)

    def get(self, name: str, default: str | None = None) -> str | None:
        """The value of the attribute of that name."""
        for one in self.attributes:
            if one.name == name:
                return one.value
        return default

    def written(self, name: str) -> str | None:
        """The value of the attribute of that name, its tabs and newlines kept; None if there is none."""
        for one in self.attributes:
            if one.name == name:
                return one.written
        return None

    def child(self, name: str) -> Element | None:
        """The first element of that name in it."""
        for one in self.children:
            if one.name == name:
                return one
        return None

    def all(self, name: str) -> list[Element]:
        """All elements of that name directly in it."""
        return [one for one in self.children if one.name == name]

    def walk(self) -> Iterator[Element]:
        """This element and all below it, in the order of the text."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))

    def span_of(self, attribute: str) -> Span:
        """Where the value of an attribute stands; the element's own place if it has none."""
        found = self.attribute(attribute)
        return self.span if found is None else found.value_span

    @property
    def path(self) -> str:
        """Where it is in the tree, for people: `robot/link[torso]/visual[2]/geometry`.

        In brackets stands its attribute `name`, or its number (from 1) among elements of the same name and parent if there
        are several.
        """
        steps: list[str] = []
        element: Element | None = self
        while element is not None:
            steps.append(element._step())
            element = element.parent
        return "/".join(reversed(steps))

    def _step(self) -> str:
        name = self.get("name")
        if name and self.parent is not None:
            return f"{self.name}[{name}]"
        twins = [] if self.parent is None else self.parent.all(self.name)
        return f"{self.name}[{twins.index(self) + 1}]" if len(twins) > 1 else self.name


@dataclass(frozen=True, kw_only=True)
class Document:
    """One XML text."""

    file: str
    """Name to show for it, e.g. `hello_ros/urdf/hello_ros_robot_1.urdf`."""
    text: str
    """The text, newlines as `\\n`."""
    lines: tuple[str, ...]
    """The same in lines, without the newlines."""
    roots: tuple[Element, ...]
    """The elements outside of all others: one, if the text is well-formed."""
    root_end: Span | None
    """Where the end tag of the first of them stands; None if it is not closed."""
    faults: tuple[Fault, ...]
    """What is wrong with it as XML, in the order of the text."""
    has_wide_letters: bool = False
    """Whether it was read from UTF-16, which is XML, but which TinyXML (and so ROS) does not read."""

    @property
    def root(self) -> Element | None:
        """The first element outside of all others; None if there is none."""
        return self.roots[0] if self.roots else None

    @property
    def is_well_formed(self) -> bool:
        """Whether a strict parser would take it."""
        return not self.faults

    def line(self, number: int) -> str:
        """A line of the text, from 1; empty beyond its end."""
        return self.lines[number - 1] if 0 < number <= len(self.lines) else ""
