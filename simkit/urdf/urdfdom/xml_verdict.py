"""Whether urdfdom reads on where a text is no well-formed XML, and which of its elements it sees.

It reads XML with TinyXML, which is more lenient than XML in some places: it takes values without quotation marks, a stray
`&`, `--` in comments, and anything behind the root. It gives up at the first fault that it does not get over, and says little
about it; what is said here instead names the fault and its line.

Source: the behaviour of TinyXML 2.6.2, which urdfdom uses up to version 3.
"""

from __future__ import annotations

import re

from simkit.xml import Document, Element, Fault, FaultKind

EMPTY = "Error document empty."
NO_ROBOT = "Could not find the 'robot' element in the xml file"
_READ_ON = {
    FaultKind.ENCODING: "it knows bytes only",
    FaultKind.DECLARATION: "a declaration may stand anywhere",
    FaultKind.LOOSE_ATTRIBUTE: "a value ends at the next space, and needs no quotation marks",
    FaultKind.MARKUP: "what is no tag is skipped up to the next >",
    FaultKind.BAD_CHARACTER: "letters are not looked at, and a stray & is dropped",
    FaultKind.ENTITY: "the & of an unknown one is dropped",
    FaultKind.TOO_DEEP: "it has no such limit",
}
"""The faults that TinyXML gets over, and why; at all others it gives up, if they stand before the end of the root."""
_SKIPPED = re.compile(r"<!--.*?-->|<[^>]*>", re.DOTALL)


class XmlRefusedError(Exception):
    """urdfdom refuses the text as XML; holds its words, or ours for a text that is not well-formed."""


def robot_element(document: Document) -> Element:
    """The element `<robot>` that urdfdom finds.

    Raises:
        XmlRefusedError: It gives up, or there is no such element.
    """
    text = document.text.lstrip()
    if document.has_wide_letters or not text.startswith("<"):
        raise XmlRefusedError(EMPTY)
    fault = next((one for one in document.faults if _ends_reading(one, document)), None)
    if fault is not None:
        place = f"line {fault.span.line}, column {fault.span.column}"
        raise XmlRefusedError(f"not well-formed XML: {place}: {fault.what}")
    robot = next((root for root in document.roots if root.name == "robot"), None)
    if robot is None or _is_cut_off(document):
        raise XmlRefusedError(NO_ROBOT)
    return robot


def _ends_reading(fault: Fault, document: Document) -> bool:
    """Whether TinyXML gives up at a fault."""
    if fault.kind is FaultKind.EMPTY or (fault.kind in _READ_ON and not _is_zero(fault, document)):
        return False
    return document.root_end is None or fault.span <= document.root_end


def _is_zero(fault: Fault, document: Document) -> bool:
    """Whether a fault is a zero byte, at which C ends a text."""
    return document.line(fault.span.line)[fault.span.column - 1 :].startswith("\0")


def _is_cut_off(document: Document) -> bool:
    """Whether something before the root ends the reading: TinyXML takes the first `>` for the end of a document type."""
    root = document.roots[0].span
    before = "\n".join(
        [*document.lines[: root.line - 1], document.lines[root.line - 1][: root.column - 2]]
    )
    return bool(_SKIPPED.sub("", before).strip())
