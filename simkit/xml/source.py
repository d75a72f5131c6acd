"""The text that is read: bytes decoded, places in it, and the faults found so far.

Source:
    XML 1.0, appendix F (how an encoding is found out).
"""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass, replace

from simkit.xml.document import Fault, FaultKind, Lines, Span

MAX_FAULTS = 200
"""Faults that are kept; whoever has that many is not helped by more of them, and reading ends."""


class Source(Lines):
    """A text, the places in it, and what is wrong with it.

    Args:
        text: The text, with newlines as line ends.
    """

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.faults: list[Fault] = []
        self.cut_off = False
        """Whether the text ends in the middle of a tag, and a fault says so."""
        self.has_definitions = False
        """Whether a document type defines entities, so that those that we do not know are none of our business."""
        self._next: dict[tuple[str, bool], tuple[int, int]] = {}

    @property
    def is_full(self) -> bool:
        """Whether further faults are not kept."""
        return len(self.faults) >= MAX_FAULTS

    def find(self, wanted: str, start: int, *, is_ahead: bool = False) -> int:
        """Where a text comes next at or behind `start`; -1 if it does not.

        The last answer for each text is remembered: asking over and over from places further and further on reads the file
        once, however often the answer is the same. Who looks ahead has a memory of his own.
        """
        asked, answer = self._next.get((wanted, is_ahead), (0, -2))
        if answer == -2 or start < asked or 0 <= answer < start:
            answer = self.text.find(wanted, start)
            self._next[wanted, is_ahead] = (start, answer)
        return answer

    def fault(
        self,
        kind: FaultKind,
        start: int,
        end: int,
        *,
        what: str,
        remedy: str,
        other: Span | None = None,
    ) -> None:
        """Note a fault at a piece of the text."""
        self.fault_at(kind, self.span(start, end), what=what, remedy=remedy, other=other)

    def fault_at(
        self, kind: FaultKind, span: Span, *, what: str, remedy: str, other: Span | None = None
    ) -> None:
        """Note a fault at a place; the remedy becomes a sentence with a full stop."""
        if not self.is_full:
            remedy = remedy if remedy.endswith(".") else f"{remedy}."
            self.faults.append(Fault(kind=kind, span=span, what=what, remedy=remedy, other=other))


_DECLARED = re.compile(rb"\s*<\?xml\s(?:[^>]*?\s)?encoding\s*=\s*[\"']([A-Za-z][\w.-]*)[\"']")
_DECLARED_IN_TEXT = r"<\?xml\s(?:[^>]*?\s)?encoding\s*=\s*[\"']([A-Za-z][\w.-]*)[\"']"
_LOOKED_AT = 400
_ASCII = bytes([9, 10, 13, *range(32, 127)])
_NO_SETS = {"unicode_escape", "raw_unicode_escape", "utf-7", "idna", "punycode", "mbcs", "oem"}


@dataclass(frozen=True, kw_only=True)
class Decoded:
    """The text of some bytes."""

    text: str
    """The text; what is no text in the encoding is U+FFFD in it."""
    has_wide_letters: bool = False
    """Whether each letter takes two bytes or four (UTF-16), as some editors and PowerShell write it."""
    what: str = ""
    """What is wrong with the encoding; empty if nothing is."""
    remedy: str = ""
    """What would be right."""
    at: int = 0
    """Index in the text where it is wrong."""


def decode(data: bytes) -> Decoded:
    """Decode bytes as their byte order mark or XML declaration says; as UTF-8 if neither does."""
    if data[:3] == codecs.BOM_UTF8:
        return _eight_bit(data[3:])
    for mark, name in ((codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be")):
        if data[:2] == mark:
            return _sixteen_bit(data[2:], name)
    if len(data) > 1 and 0 in data[:2] and data[:2] != b"\0\0":
        return _sixteen_bit(data, "utf-16-be" if data[0] == 0 else "utf-16-le")
    return _eight_bit(data)


def _sixteen_bit(data: bytes, encoding: str) -> Decoded:
    decoded = replace(_decode(data, encoding, encoding.upper()), has_wide_letters=True)
    declared = re.match(_DECLARED_IN_TEXT, decoded.text[:_LOOKED_AT])
    if declared is None or declared[1].lower() in (
        "utf-16",
        encoding,
        encoding.replace("-", "", 1),
    ):
        return decoded
    if decoded.what:
        return decoded
    return Decoded(
        text=decoded.text,
        has_wide_letters=True,
        what=f"the file says that it is {declared[1]}, but it is {encoding.upper()}",
        remedy='Save it as UTF-8, or write encoding="UTF-16".',
        at=declared.start(1),
    )


def _eight_bit(data: bytes) -> Decoded:
    declared = _DECLARED.match(data[:_LOOKED_AT])
    name = declared[1].decode("ascii") if declared else "UTF-8"
    at = len(data[: declared.start(1)].decode("utf-8", "replace")) if declared else 0
    try:
        codec = _codec(name)
    except LookupError:
        return Decoded(
            text=data.decode("utf-8", "replace"),
            what=f"{name} is not the name of an encoding that a file like this one can have",
            remedy='Save the file as UTF-8 and write encoding="UTF-8".',
            at=at,
        )
    return _decode(data, codec, name)


def _codec(name: str) -> str:
    """The codec of an encoding with one byte for each letter of ASCII.

    Raises:
        LookupError: There is none of that name, or it has two bytes for each letter, or it is no encoding of a file.
    """
    if name.lower() in ("utf-8", "utf8"):
        return "utf-8"
    codec = codecs.lookup(name)
    if codec.name in _NO_SETS or not codec._is_text_encoding:
        raise LookupError(name)
    try:
        if bytes(_ASCII).decode(codec.name) == _ASCII.decode("ascii"):
            return codec.name
    except UnicodeError:
        pass
    raise LookupError(name)


def _decode(data: bytes, codec: str, name: str) -> Decoded:
    try:
        return Decoded(text=data.decode(codec))
    except UnicodeDecodeError as error:
        text = data.decode(codec, "replace")
        at = len(data[: error.start].decode(codec, "replace"))
        found = data[error.start]
        meant = bytes([found]).decode("cp1252", "ignore")
        guess = (
            f" (perhaps {meant}, if the file was saved as Windows-1252)"
            if found > 127 and meant
            else ""
        )
        return Decoded(
            text=text,
            what=f"the byte 0x{found:02X}{guess} is not {name.upper()}, the encoding of this file",
            remedy="Save the file as UTF-8 in your editor, or type this letter anew.",
            at=at,
        )
