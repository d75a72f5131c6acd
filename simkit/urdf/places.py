"""Where in the document an element of TinyXML's stands: the two readers of one text are joined by place."""

from __future__ import annotations

import re
from bisect import bisect_right

from simkit.urdf.urdfdom.tinyxml import TinyElement
from simkit.xml import Attribute, Document, Element, Span

_NEWLINE = re.compile(rb"\r\n|\r|\n")
_MARK = b"\xef\xbb\xbf"


class Places:
    """Finds elements of a document by their offset in its bytes.

    Args:
        document: The text, read by `simkit.xml`.
        data: The text's bytes.
    """

    def __init__(self, document: Document, data: bytes) -> None:
        self._data = data
        self._starts = [0, *(match.end() for match in _NEWLINE.finditer(data))]
        elements = [] if document.root is None else document.root.walk()
        self._elements = {(one.span, one.name): one for one in elements}

    def element(self, tiny: TinyElement) -> Element:
        """The element of the document; one made for the purpose where the document has none there."""
        span = self._span(tiny)
        return self._elements.get((span, tiny.name)) or _made(tiny, span)

    def _span(self, tiny: TinyElement) -> Span:
        line = bisect_right(self._starts, tiny.offset)
        before = self._data[self._starts[line - 1] : tiny.offset]
        if line == 1:
            before = before.removeprefix(_MARK)
        return Span(line, len(before.decode("utf-8", "replace")) + 1, max(len(tiny.name), 1))


def _made(tiny: TinyElement, span: Span) -> Element:
    attributes = tuple(
        Attribute(name=name, value=value, name_span=span, value_span=span)
        for name, value in tiny.attributes.items()
    )
    return Element(name=tiny.name, span=span, attributes=attributes)
