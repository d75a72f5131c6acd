"""XML as TinyXML reads it: more lenient than XML in some places, stricter in others.

urdfdom's verdict begins here. TinyXML takes values without quotation marks, a stray `&`, `--` in
comments and anything behind the root. It gives up at the first fault, and says little about it.

It knows bytes only. So the text is kept with one letter a byte until a value leaves this module.

Source: the behaviour of TinyXML 2.6.2, which urdfdom uses up to version 3.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from simkit.urdf.urdfdom.tiny_text import LostError, behind_space, quoted, skip_text

_NAME = re.compile(r"[A-Za-z_\x7f-\xff][A-Za-z0-9_.:\-\x7f-\xff]*")
_PLAIN_ATTRIBUTE = re.compile(
    r"""[\t-\r ]*+([A-Za-z_][\w.:-]*+)="([^"&\x7f-\xff]*+)"(?=[\t-\r />])""", re.A
)
_BARE_VALUE = re.compile(r"[^\t-\r />\"']*")
_DECLARATION = re.compile(r"<\?xml", re.IGNORECASE)
_DECLARED = re.compile(r"version|encoding|standalone", re.IGNORECASE)
_WORD = re.compile(r"[^>\t-\r ]*")

_NO_NAME = "Failed to read Element name"
_ATTRIBUTES = "Error reading Attributes."
_EMPTY_TAG = "Error: empty tag."
_ELEMENT = "Error parsing Element."
_VALUE = "Error reading Element value."
_END_TAG = "Error reading end tag."
_NOTHING = "Error document empty."


class TinyXmlError(Exception):
    """TinyXML gives up; holds its words."""


class TinyElement:
    """An element that TinyXML has read.

    A plain class: it is made in a third of the time of a dataclass, and so is each element.

    Args:
        name: Its name.
        offset: Where its name stands in the text [bytes].
    """

    __slots__ = ("attributes", "children", "name", "offset")

    def __init__(self, name: str, offset: int) -> None:
        self.name = name
        self.offset = offset
        self.attributes: dict[str, str] = {}
        self.children: list[TinyElement] = []

    def get(self, name: str) -> str | None:
        """The value of an attribute; None if it is missing."""
        return self.attributes.get(name)

    def child(self, name: str) -> TinyElement | None:
        """The first element of that name in it."""
        return next(self.all(name), None)

    def all(self, name: str) -> Iterator[TinyElement]:
        """All elements of that name in it."""
        return (one for one in self.children if one.name == name)


def parse_tiny(data: bytes) -> list[TinyElement]:
    """The elements outside of all others, in their order.

    Raises:
        TinyXmlError: TinyXML gives up.
    """
    return _Parser(data.partition(b"\0")[0].decode("latin-1")).roots()


class _Parser:
    def __init__(self, text: str) -> None:
        self._text = text
        self._at = 0
        self._knows_encoding = self._is_utf8 = text.startswith("\xef\xbb\xbf")

    def roots(self) -> list[TinyElement]:
        """What is outermost, up to the first thing that is no tag; whatever follows is not looked at."""
        found: list[TinyElement] = []
        is_empty = True
        try:
            self._skip_space()
            while self._sees("<"):
                is_empty = False
                if self._sees_element():
                    found.append(self._element())
                else:
                    self._skip_node(is_outermost=True)
                self._skip_space()
        except LostError:
            pass
        if is_empty:
            raise TinyXmlError(_NOTHING)
        return found

    def _element(self) -> TinyElement:
        root, is_open = self._start_tag()
        opened = [root] if is_open else []
        while opened:
            self._skip_content()
            if self._sees("</"):
                self._end_tag(opened.pop())
                continue
            element, is_open = self._start_tag()
            opened[-1].children.append(element)
            if is_open:
                opened.append(element)
        return root

    def _skip_content(self) -> None:
        """Go to the next tag: a start or an end."""
        try:
            while True:
                self._skip_space()
                if self._is_over():
                    raise TinyXmlError(_END_TAG)
                if not self._sees("<"):
                    self._at = skip_text(self._text, self._at, is_utf8=self._is_utf8)
                elif self._sees("</") or self._sees_element():
                    return
                else:
                    self._skip_node(is_outermost=False)
        except LostError:
            raise TinyXmlError(_VALUE) from None

    def _start_tag(self) -> tuple[TinyElement, bool]:
        """Read a start tag; also says whether the element goes on behind it."""
        self._at += 1
        offset, name = self._at, self._name(_NO_NAME)
        element = TinyElement(_decoded(name), offset)
        while True:
            self._take_plain_attributes(element.attributes)
            self._skip_space_or(_ATTRIBUTES)
            if self._take("/>"):
                return element, False
            if self._sees("/"):
                raise TinyXmlError(_EMPTY_TAG)
            if self._take(">"):
                return element, True
            try:
                name, value = self._attribute()
            except LostError:
                raise TinyXmlError(_ELEMENT) from None
            if self._is_over() or name in element.attributes:
                raise TinyXmlError(_ELEMENT)
            element.attributes[name] = value

    def _take_plain_attributes(self, attributes: dict[str, str]) -> None:
        """Read attributes as long as they are as most are: without entities, in double quotation marks."""
        while match := _PLAIN_ATTRIBUTE.match(self._text, self._at):
            name, value = match.groups()
            if name in attributes:
                raise TinyXmlError(_ELEMENT)
            attributes[name] = value
            self._at = match.end()

    def _end_tag(self, element: TinyElement) -> None:
        match = _NAME.match(self._text, element.offset)
        assert match is not None  # it was read there before
        if not self._take("</" + match.group()):
            raise TinyXmlError(_END_TAG)
        self._skip_space_or(_END_TAG)
        if not self._take(">"):
            raise TinyXmlError(_END_TAG)

    def _attribute(self) -> tuple[str, str]:
        name = self._name(_ATTRIBUTES)
        self._skip_space_or(_ATTRIBUTES)
        if not self._take("="):
            raise TinyXmlError(_ATTRIBUTES)
        self._skip_space_or(_ATTRIBUTES)
        quote = self._text[self._at]
        if quote in "\"'":
            value, self._at = quoted(self._text, self._at + 1, quote, is_utf8=self._is_utf8)
        else:
            value = self._match(_BARE_VALUE)
            if self._text[self._at : self._at + 1] in ('"', "'"):
                raise TinyXmlError(_ATTRIBUTES)
        return _decoded(name), _decoded(value)

    def _skip_node(self, *, is_outermost: bool) -> None:
        """Go behind something between `<` and `>` that is no element."""
        if _DECLARATION.match(self._text, self._at):
            self._skip_declaration(is_outermost=is_outermost)
        elif self._sees("<!--"):
            self._at = self._behind("-->", self._at + 4, len(self._text))
        elif self._sees("<![CDATA["):
            self._at = self._behind("]]>", self._at + 9, None)
        else:
            self._at = self._behind(">", self._at + 1, len(self._text))

    def _skip_declaration(self, *, is_outermost: bool) -> None:
        """Go behind `<?xml ... ?>`; the first one outside of the root says what the encoding is."""
        self._at += 5
        encoding = ""
        while not self._take(">"):
            self._skip_space()
            declared = _DECLARED.match(self._text, self._at)
            if declared is None:
                self._match(_WORD)
                continue
            try:
                _, value = self._attribute()
            except TinyXmlError:
                raise LostError from None
            if declared.group().lower() == "encoding":
                encoding = value
        if is_outermost and not self._knows_encoding:
            self._knows_encoding = True
            self._is_utf8 = not encoding or encoding.upper().startswith(("UTF-8", "UTF8"))

    def _behind(self, end: str, start: int, otherwise: int | None) -> int:
        found = self._text.find(end, start)
        if found >= 0:
            return found + len(end)
        if otherwise is None:
            raise LostError
        return otherwise

    def _sees(self, what: str) -> bool:
        return self._text.startswith(what, self._at)

    def _take(self, what: str) -> bool:
        found = self._sees(what)
        self._at += len(what) * found
        return found

    def _sees_element(self) -> bool:
        return _NAME.match(self._text, self._at + 1) is not None

    def _is_over(self) -> bool:
        return self._at == len(self._text)

    def _match(self, pattern: re.Pattern[str]) -> str:
        match = pattern.match(self._text, self._at)
        if match is None:
            return ""
        self._at = match.end()
        return match.group()

    def _name(self, complaint: str) -> str:
        name = self._match(_NAME)
        if not name or self._is_over():
            raise TinyXmlError(complaint)
        return name

    def _skip_space(self) -> None:
        self._at = behind_space(self._text, self._at, is_utf8=self._is_utf8)

    def _skip_space_or(self, complaint: str) -> None:
        """Skip white space; something must follow."""
        if not self._is_over():
            self._skip_space()
        if self._is_over():
            raise TinyXmlError(complaint)


def _decoded(value: str) -> str:
    """A name or value as it leaves: up to a zero byte, as C has it, and as UTF-8."""
    value = value.partition("\0")[0]
    return value if value.isascii() else value.encode("latin-1").decode("utf-8", "backslashreplace")
