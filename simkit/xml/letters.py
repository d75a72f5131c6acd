"""Which letters XML allows where, patterns with them, how to speak of others, and references such as `&lt;` and `&#176;`.

There are five entities; a text cannot make more of them.

Source:
    XML 1.0, fifth edition: 2.2 (characters), 2.3 (names; without the letters that cannot be seen).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from simkit.xml.document import FaultKind
from simkit.xml.source import Source

START = (
    ":A-Z_a-z\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u02ff\u0370-\u037d\u037f-\u1fff"
    "\u2070-\u218f\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufefe\uff00-\uffef\U00010000-\U000effff"
)
"""Inside of brackets: the letters that can begin a name."""
ASCII_START = ":A-Z_a-z"
"""The same for a text of plain letters."""
NAME_START = f"[{START}]"
"""Pattern of a letter that can begin a name."""
INNER = "\u00b7\u0300-\u036f\u203f-\u2040"
"""Inside of brackets: the letters beyond ASCII that a name can have, but not begin with."""
NAME = rf"{NAME_START}[-.0-9{INNER}{START}]*+"
"""Pattern of a name of an element, attribute, entity or processing instruction."""
SPACE = "[ \t\n]"
"""Pattern of one white space of XML; other kinds of space are letters like any other."""
WHITE = " \t\n"
"""The same for `strip`."""
FOREIGN_LETTERS = "[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]"
"""Pattern of a letter that no XML text may hold; line ends are newlines already."""
FOREIGN_ASCII = "[^\t\n\x20-\x7f]"
"""The same for a text of plain letters."""
QUOTES = "\u201c\u201d\u201e\u201f\u2018\u2019\u201a\u2033\u2032\u00ab\u00bb\u00b4`"
"""Quotation marks of books and word processors, which are none to XML."""

_KNOWN = {
    "\u00a0": "a no-break space, which only looks like a space",
    "\u200b": "a zero-width space, which cannot be seen",
    "\u2060": "a word joiner, which cannot be seen",
    "\u00ad": "a soft hyphen, which cannot be seen",
    "\ufeff": "a byte order mark, which cannot be seen",
    "\u2013": "a dash of a word processor",
    "\u2014": "a dash of a word processor",
    "\ufffd": "the mark of a letter that could not be read",
    "\x00": "a zero byte",
    "\x1b": "an escape character",
}
_LONGEST = 40


def is_foreign(letter: str) -> bool:
    """Whether no XML text may hold a letter."""
    code = ord(letter)
    return (
        (code < 0x20 and letter not in "\t\n")
        or 0xD800 <= code < 0xE000
        or code in (0xFFFE, 0xFFFF)
    )


def spoken(letter: str) -> str:
    """A letter as a message names it: `U+00A0 (a no-break space, which only looks like a space)`."""
    code = f"U+{ord(letter):04X}"
    if letter in _KNOWN:
        return f"{code} ({_KNOWN[letter]})"
    if is_foreign(letter):
        return f"{code} (a control character)" if letter < "\x20" else code
    if letter in QUOTES:
        return f"{letter} (a quotation mark of a word processor)"
    return f"`{letter}`" if letter.isascii() or letter.isprintable() else code


def excerpt(text: str) -> str:
    """A piece of the file for a message: on one line, not too long, nothing in it that moves a terminal."""
    text = " ".join(text[: 4 * _LONGEST].split())
    text = "".join(letter if letter.isprintable() else "\ufffd" for letter in text)
    return text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."


_TOO_MANY = "there is a quotation mark {} too many"
_SEPARATED = "attributes are separated by spaces, not by {}"
_KNOWN_JUNK = {
    **{q: (_TOO_MANY.format(q), f"Delete it, or write name={q}...{q}") for q in ('"', "'")},
    "=": ("there is no name before this =", 'Write name="value"'),
    ",": (_SEPARATED.format("commas"), "Delete the comma."),
    ";": (_SEPARATED.format("semicolons"), "Delete the semicolon."),
}


def words_on_junk(junk: str) -> tuple[str, str]:
    """What is wrong with letters that do not belong into a tag, and what to do."""
    if junk in _KNOWN_JUNK:
        return _KNOWN_JUNK[junk]
    if not junk.isascii() and len(set(junk)) == 1:
        remedy = "Delete it, and type a space where one is needed."
        return f"in the tag stands {spoken(junk[0])}", remedy
    what = f"{excerpt(junk)} does not belong to an attribute"
    return what, f'Delete it, or write name="{excerpt(junk)}"'


class Pattern:
    """A regular expression, used as a compiled one is; compiled when it is first needed, and cheaply for plain letters.

    One with the names of XML in it takes milliseconds to compile, for its thousands of letters. Most files
    have none of them, and most patterns are for faults that most files do not have.

    Args:
        pattern: The expression; may hold `NAME`, `NAME_START` and `FOREIGN_LETTERS`.
        flags: As for `re.compile`.
    """

    __slots__ = ("_flags", "_of_any", "_of_ascii", "_pattern")

    def __init__(self, pattern: str, flags: re.RegexFlag = re.NOFLAG) -> None:
        self._pattern = pattern
        self._flags = flags
        self._of_ascii: re.Pattern[str] | None = None
        self._of_any: re.Pattern[str] | None = None

    def match(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).match(text, *span)

    def search(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).search(text, *span)

    def fullmatch(self, text: str, *span: int) -> re.Match[str] | None:
        """As that of a compiled pattern."""
        return self.of(text).fullmatch(text, *span)

    def finditer(self, text: str, *span: int) -> Iterator[re.Match[str]]:
        """As that of a compiled pattern."""
        return self.of(text).finditer(text, *span)

    def of(self, text: str) -> re.Pattern[str]:
        """The compiled pattern for a text; who matches often keeps it."""
        if text.isascii():
            if self._of_ascii is None:
                plain = self._pattern.replace(START, ASCII_START).replace(INNER, "")
                plain = plain.replace(FOREIGN_LETTERS, FOREIGN_ASCII)
                self._of_ascii = re.compile(plain, self._flags)
            return self._of_ascii
        if self._of_any is None:
            self._of_any = re.compile(self._pattern, self._flags)
        return self._of_any


ENTITIES = {"lt": "<", "gt": ">", "amp": "&", "apos": "'", "quot": '"'}

_REFERENCE = Pattern(rf"&(?:#([0-9]++);|#x([0-9a-fA-F]++);|({NAME});)?")
_BARE = Pattern(rf"&(#?)({NAME}|[0-9]++|)")
_DIGITS = 8
TO_SPACE = str.maketrans("\t\n", "  ")
"""For `str.translate`: the white space of a value as XML normalises it."""


def replace_references(source: Source, start: int, end: int) -> str:
    """The text from `start` to `end` with its references replaced; faulty ones stay as they are, and are noted."""
    return "".join(_pieces(source, start, end))


def replace_in_value(source: Source, start: int, end: int) -> tuple[str, str]:
    """The same of an attribute's value, as it is written and normalised: tabs and newlines as spaces, but not references."""
    pieces = list(_pieces(source, start, end))
    normalised = [*pieces]
    normalised[::2] = [one.translate(TO_SPACE) for one in pieces[::2]]
    return "".join(pieces), "".join(normalised)


def _pieces(source: Source, start: int, end: int) -> Iterator[str]:
    """In turn a text without a reference, and the meaning of one."""
    text = source.text
    for found in _REFERENCE.finditer(text, start, end) if text.find("&", start, end) >= 0 else ():
        yield text[start : found.start()]
        yield _meaning(source, found)
        start = found.end()
        if source.is_full:
            break
    yield text[start:end]


def _meaning(source: Source, found: re.Match[str]) -> str:
    decimal, hexadecimal, name = found.groups()
    if name is not None:
        return _entity(source, found)
    if decimal is None and hexadecimal is None:
        _bare(source, found.start())
        return found[0]
    digits = (decimal or hexadecimal).lstrip("0") or "0"
    code = int(digits, 10 if decimal else 16) if len(digits) < _DIGITS else 0
    if code <= 0x10FFFF and (chr(code) == "\r" or not is_foreign(chr(code))):
        return chr(code)
    source.fault(
        FaultKind.BAD_CHARACTER,
        found.start(),
        found.end(),
        what=f"{excerpt(found[0])} is not the number of a letter that XML allows",
        remedy="Write the letter itself, or its number in Unicode, e.g. &#176; for °.",
    )
    return found[0]


def _entity(source: Source, found: re.Match[str]) -> str:
    name = found[3]
    if name in ENTITIES:
        return ENTITIES[name]
    if not (source.has_definitions or source.is_full):
        source.fault(
            FaultKind.ENTITY,
            found.start(),
            found.end(),
            what=f"XML has no entity {excerpt(found[0])}; it has &lt; &gt; &amp; &quot; &apos;",
            remedy=_entity_remedy(name),
        )
    return found[0]


def _entity_remedy(name: str) -> str:
    from html.entities import html5  # a long table, wanted for this one sentence

    if name.lower() in ENTITIES:
        return f"Write &{name.lower()}; in small letters."
    letter = html5.get(f"{name};", "")
    if len(letter) == 1 and letter.isprintable():
        return f"Write the letter itself: {letter}"
    return f"Write &amp;{excerpt(name)}; if the sign & is meant, or else the text that you want."


def _bare(source: Source, at: int) -> None:
    if source.is_full:
        return
    found = _BARE.match(source.text, at)
    is_number, name = (found[1], found[2]) if found else ("", "")
    if name and (is_number or name in ENTITIES):
        what = f"{excerpt(f'&{is_number}{name}')} has no semicolon at its end"
        remedy = f"Write {excerpt(f'&{is_number}{name};')}"
        if is_number and name[0] == "X":
            what, remedy = "the x of &#x...; is a small letter", f"Write &#x{excerpt(name[1:])};"
    else:
        what, remedy = (
            "& begins an entity such as &lt; and cannot stand alone",
            "Write &amp; for the sign &.",
        )
        is_number = name = ""
    is_number_sign = source.text.startswith("&#", at)
    kind = FaultKind.BAD_REFERENCE if is_number_sign else FaultKind.BAD_CHARACTER
    source.fault(kind, at, at + 1 + len(is_number + name), what=what, remedy=remedy)
