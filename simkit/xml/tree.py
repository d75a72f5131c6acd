"""Puts tags and texts together to a tree of elements."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from itertools import islice
from typing import NamedTuple

from simkit.errors import near_names
from simkit.xml.document import Element, FaultKind, Span
from simkit.xml.letters import WHITE, excerpt
from simkit.xml.repair import (
    OpenElement,
    is_twin,
    note_bare_tag,
    note_mismatched,
    note_misspelt,
    repair_end_of_file,
    repair_unclosed,
    wrap_loose,
)
from simkit.xml.source import Source
from simkit.xml.tags import EndTag, StartTag, Text, Token

MAX_DEPTH = 256
"""Elements inside of each other that are kept."""
_FAR = 600
"""Tokens that are looked at ahead for the next end tag."""
_LONGEST_NAME = 40
"""A longer name is no slip of the pen."""
_TAG = re.compile(r"<[A-Za-z_!?/\\]|<\s+\w[^<>]*>")


class Tree(NamedTuple):
    """The elements of a text."""

    roots: tuple[Element, ...]
    """Those that stand outside of all others."""
    root_end: Span | None
    """The end tag of the first of them; None if it is not closed."""


def build_tree(source: Source, tokens: Sequence[Token]) -> Tree:
    """The tree that the tokens make."""
    builder = _Builder(source, tokens)
    builder.build()
    return Tree(roots=tuple(builder.roots), root_end=builder.root_end)


class _Builder:
    def __init__(self, source: Source, tokens: Sequence[Token]) -> None:
        self.roots: list[Element] = []
        self.root_end: Span | None = None
        self._source = source
        self._tokens = tokens
        self._open: list[OpenElement] = []
        self._names: Counter[str] = Counter()
        self._closed_by: dict[str, StartTag | EndTag] = {}
        self._unclosed: Counter[str] = Counter()
        self._said: set[tuple[FaultKind, bool]] = set()

    def build(self) -> None:
        for number, token in enumerate(self._tokens):
            if isinstance(token, StartTag):
                self._start(token)
            elif isinstance(token, Text):
                self._text(token)
            else:
                self._end(number, token)
        if self._open:
            for one in self._open:
                _keep_text(one)
            repair_end_of_file(self._source, self._open)
        if not self.roots:
            self._note_empty()

    # -- start tags and text

    def _start(self, tag: StartTag) -> None:
        if self._unclosed:
            self._unclosed.clear()
        parent = self._open[-1] if self._open else None
        element = None
        if parent is None and self.roots:
            self._note_second_root(tag)
        if len(self._open) >= MAX_DEPTH:
            what = f"more than {MAX_DEPTH} elements stand inside of each other; the inner ones are left out"
            remedy = "Close elements before the next ones begin."
            self._once(FaultKind.TOO_DEEP, tag.at, tag.at + len(tag.name), what, remedy)
        elif parent is None or parent.element is not None:
            element = self._element(tag, None if parent is None else parent.element)
        if tag.is_closed:
            self._closed_by[tag.name] = tag
            self._note_root_end(tag)
        else:
            self._open.append(OpenElement(tag, element))
            self._names[tag.name] += 1

    def _element(self, tag: StartTag, parent: Element | None) -> Element:
        element = Element(
            name=tag.name,
            span=self._source.span(tag.at, tag.at + len(tag.name)),
            attributes=tag.attributes,
            parent=parent,
        )
        (self.roots if parent is None else parent.children).append(element)
        return element

    def _text(self, text: Text) -> None:
        if text.is_plain and not text.value.strip(WHITE):
            if self._open and self._open[-1].element is not None:
                self._open[-1].texts.append(text)
            return
        raw = self._source.text[text.at : text.end]
        first = text.at + len(raw) - len(raw.lstrip(WHITE))
        if not self._open:
            if first < text.end and raw != "<":  # which is a fault of its own
                what = "this text stands outside of the root element"
                remedy = "Delete it, or write <!-- ... --> around it."
                self._once(FaultKind.STRAY_TEXT, first, text.end, what, remedy)
            return
        top = self._open[-1]
        if top.element is not None:
            top.texts.append(text)
            if top.element.text_span is None and text.value.strip(WHITE):
                end = text.at + len(raw.rstrip(WHITE))
                top.element.text_span = self._source.span(first, end)

    # -- end tags

    def _end(self, number: int, tag: EndTag) -> None:
        is_open = self._names[tag.name] > 0
        if not self._open:
            self._stray(tag)
        elif not tag.name or tag.name == self._open[-1].name:
            self._close(tag)
        elif is_open:
            while self._open[-1].name != tag.name:
                self._leave_unclosed(tag)
            self._close(tag)
        elif self._source.is_full:
            return
        elif _is_misspelt(tag.name, self._open[-1].name):
            note_misspelt(self._source, tag, self._open[-1].tag)
            self._close(tag)
        elif len(self._open) > 1 and self._next_end(number) == self._open[-2].name:
            note_mismatched(self._source, tag, self._open[-1].tag)
            self._close(tag)
        else:
            self._stray(tag)

    def _pop(self) -> OpenElement:
        one = self._open.pop()
        self._names[one.name] -= 1
        _keep_text(one)
        return one

    def _close(self, tag: EndTag) -> None:
        self._pop()
        self._closed_by[tag.name] = tag
        self._note_root_end(tag)

    def _leave_unclosed(self, tag: EndTag) -> None:
        one = self._pop()
        outer = self._open[-1]
        if self._source.is_full:
            return
        if one.name == outer.name and is_twin(one.tag.attributes, outer):
            return  # it was to be the end tag of the outer one, which is settled next, as its twin
        self._unclosed[one.name] += 1
        repair_unclosed(self._source, one, tag)

    def _next_end(self, number: int) -> str | None:
        """Name of the next end tag behind token `number` of an element that is open there."""
        depth = 0
        for token in islice(self._tokens, number + 1, number + 1 + _FAR):
            if isinstance(token, StartTag):
                depth += not token.is_closed
            elif isinstance(token, EndTag):
                if depth == 0:
                    return token.name
                depth -= 1
        return None

    def _note_root_end(self, tag: StartTag | EndTag) -> None:
        if self.root_end is None and not self._open and self.roots:
            self.root_end = self._source.span(tag.at, tag.end)

    # -- faults of end tags

    def _stray(self, tag: EndTag) -> None:
        """Note that an end tag closes nothing, unless that follows from a fault before it."""
        if self._source.is_full or not tag.name:
            return
        if self._unclosed[tag.name]:
            self._unclosed[tag.name] -= 1
            return
        if not self._open and (FaultKind.SECOND_ROOT, False) in self._said:
            return
        top = self._open[-1] if self._open else None
        span = self._source.span(tag.at, tag.end)
        if top is not None and note_bare_tag(self._source, top, tag.name, span):
            return
        is_second = self._note_stray(tag)
        if top is not None and not is_second:
            wrap_loose(self._source, tag, top)

    def _note_stray(self, tag: EndTag) -> bool:
        """Say that an end tag closes nothing; returns whether the same stands right before it."""
        source, name = self._source, excerpt(tag.name)
        before = self._closed_by.get(tag.name)
        what = f"</{name}> closes nothing: no <{name}> is open here"
        remedy = f"Delete it, or write <{name}> where the element is to begin."
        other, is_second = None, False
        if isinstance(before, StartTag) and self._open and before.at > self._open[-1].tag.at:
            other = source.span(before.at, before.at + len(before.name))
            what = (
                f"</{name}> closes nothing: <{name}/> in line {other.line} is closed by its own /"
            )
            remedy = f"Delete the / at the end of that tag if its element ends here, or else this </{name}>"
        elif isinstance(before, EndTag) and not source.text[before.end : tag.at].strip(WHITE):
            other, is_second = source.span(before.at, before.end), True
            what = f"</{name}> stands here a second time; its element is closed already"
            remedy = f"Delete this second </{name}>"
        source.fault(FaultKind.STRAY_END, tag.at, tag.end, what=what, remedy=remedy, other=other)
        return is_second

    # -- faults of the whole file

    def _note_second_root(self, tag: StartTag) -> None:
        root = excerpt(self.roots[0].name)
        what = f"<{excerpt(tag.name)}> stands behind the end of <{root}>, the root"
        remedy = f"Move it before </{root}>: a file has one root."
        self._once(FaultKind.SECOND_ROOT, tag.at, tag.at + len(tag.name), what, remedy)

    def _note_empty(self) -> None:
        """Say that there is no element: of a text without tags only that, and nothing where faulty tags say why."""
        source = self._source
        has_tags = _TAG.search(source.text) is not None
        if has_tags and any(one.kind is not FaultKind.STRAY_TEXT for one in source.faults):
            return
        first = len(source.text) - len(source.text.lstrip(WHITE))
        what, remedy = "there is no element in this file", "Write one"
        if first == len(source.text):
            what, remedy, first = "the file is empty", "Save it in your editor, or write it", 0
        elif not has_tags:
            what = "this is no XML: there is no tag in it"
            remedy = "Look whether it is the right file"
        source.faults.clear()
        end = max(first + 1, source.text.find("\n", first))
        source.fault(FaultKind.EMPTY, first, end, what=what, remedy=remedy)

    def _once(self, kind: FaultKind, start: int, end: int, what: str, remedy: str) -> None:
        """Note a fault that needs to be said once; once before the root, and once behind it."""
        key = (kind, not self.roots)
        if key not in self._said:
            self._said.add(key)
            other = self.roots[0].span if kind is FaultKind.SECOND_ROOT else None
            self._source.fault(kind, start, end, what=what, remedy=remedy, other=other)


def _is_misspelt(name: str, other: str) -> bool:
    is_short = max(len(name), len(other)) <= _LONGEST_NAME
    return is_short and bool(near_names(name, [other]))


def _keep_text(one: OpenElement) -> None:
    if one.element is not None:
        one.element.text = one.text
