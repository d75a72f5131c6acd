"""Puts tags and texts together to a tree of elements."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from simkit.xml.document import Element, FaultKind, Span
from simkit.xml.end_tags import EndTagJudge
from simkit.xml.letters import WHITE, short
from simkit.xml.open_elements import OpenElement, OpenElements
from simkit.xml.outlook import Outlook
from simkit.xml.source import Source
from simkit.xml.tokens import EndTag, StartTag, Text, Token
from simkit.xml.unclosed import is_bare_twin, settle_end_of_file, settle_unclosed

MAX_DEPTH = 256
"""Elements inside of each other that are kept."""
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
    builder.build(tokens)
    return Tree(roots=tuple(builder.roots), root_end=builder.root_end)


class _Builder:
    def __init__(self, source: Source, tokens: Sequence[Token]) -> None:
        self.roots: list[Element] = []
        self.root_end: Span | None = None
        self._source = source
        self._open = OpenElements()
        self._outlook = Outlook(tokens)
        self._judge = EndTagJudge(source, self._outlook, self._open)
        self._skipped: EndTag | None = None
        self._said: set[tuple[FaultKind, bool]] = set()

    @property
    def root(self) -> Element | None:
        """The first element outside of all others, so far."""
        return self.roots[0] if self.roots else None

    def build(self, tokens: Sequence[Token]) -> None:
        for number, token in enumerate(tokens):
            if isinstance(token, StartTag):
                self._start(token)
            elif isinstance(token, Text):
                self._text(token)
            elif token is not self._skipped:
                self._end(number, token)
        if len(self._open):
            settle_end_of_file(self._source, self._outlook, self._open)
        if self.root is None:
            self._note_empty()

    def _start(self, tag: StartTag) -> None:
        parent = self._open.top
        element = None
        end = tag.at + len(tag.name)
        if parent is None and self.root is not None:
            what = (
                f"<{short(tag.name)}> stands behind the end of <{short(self.root.name)}>, the root"
            )
            remedy = f"Move it before </{short(self.root.name)}>: a file has one root."
            self._once(FaultKind.SECOND_ROOT, tag.at, end, what, remedy)
        if len(self._open) >= MAX_DEPTH:
            what = f"more than {MAX_DEPTH} elements stand inside of each other; the inner ones are left out"
            self._once(
                FaultKind.TOO_DEEP, tag.at, end, what, "Close elements before the next ones begin."
            )
        elif parent is None or parent.element is not None:
            element = self._element(tag, None if parent is None else parent.element)
        if tag.is_closed:
            self._judge.note_closed(tag)
            self._note_root_end(tag)
        else:
            self._open.push(OpenElement(tag, element))

    def _element(self, tag: StartTag, parent: Element | None) -> Element:
        element = Element(
            name=tag.name,
            span=self._source.span(tag.at, tag.at + len(tag.name)),
            attributes=tag.attributes,
            parent=parent,
        )
        if parent is not None:
            parent.children.append(element)
        else:
            self.roots.append(element)
        return element

    def _text(self, text: Text) -> None:
        top = self._open.top
        raw = self._source.text[text.at : text.end]
        first = text.at + len(raw) - len(raw.lstrip(WHITE))
        if top is None:
            if first < text.end and raw != "<":  # which is a fault of its own
                what = "this text stands outside of the root element"
                remedy = "Delete it, or write <!-- ... --> around it."
                self._once(FaultKind.STRAY_TEXT, first, text.end, what, remedy)
        elif top.element is not None:
            top.texts.append(text)
            if top.element.text_span is None and text.value.strip(WHITE):
                end = text.at + len(raw.rstrip(WHITE))
                top.element.text_span = self._source.span(first, end)

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
            what, remedy = (
                "this is no XML: there is no tag in it",
                "Look whether it is the right file",
            )
        source.faults.clear()
        end = max(first + 1, source.text.find("\n", first))
        source.fault(FaultKind.EMPTY, first, end, what=what, remedy=remedy)

    def _end(self, number: int, tag: EndTag) -> None:
        verdict = self._judge.judge(number, tag)
        self._skipped = verdict.skip or self._skipped
        right = 1 if verdict.skip is None else 2
        for left in range(verdict.closes - right, 0, -1):
            one, outer = self._open.pop(), self._open.top
            is_twin = left > 1 and outer is not None and is_bare_twin(one, outer)
            settle_unclosed(self._source, self._outlook, one, tag, is_twin=is_twin)
        for _ in range(min(right, verdict.closes)):
            self._open.pop()
            self._judge.note_closed(tag)
        self._note_root_end(tag)

    def _note_root_end(self, tag: StartTag | EndTag) -> None:
        """Note where the root ends, if it ended just now."""
        if self.root_end is None and not len(self._open) and self.roots:
            self.root_end = self._source.span(tag.at, tag.end)

    def _once(self, kind: FaultKind, start: int, end: int, what: str, remedy: str) -> None:
        """Note a fault that needs to be said once; once before the root, and once behind it."""
        key = (kind, self.root is None)
        if key not in self._said:
            self._said.add(key)
            other = self.root.span if kind is FaultKind.SECOND_ROOT and self.root else None
            self._source.fault(kind, start, end, what=what, remedy=remedy, other=other)
