"""Entities and character references: `&lt;`, `&#176;`. There are five entities; a text cannot make more of them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from simkit.xml.document import FaultKind
from simkit.xml.letters import NAME, Pattern, is_foreign, short
from simkit.xml.source import Source

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
        what=f"{short(found[0])} is not the number of a letter that XML allows",
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
            what=f"XML has no entity {short(found[0])}; it has &lt; &gt; &amp; &quot; &apos;",
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
    return f"Write &amp;{short(name)}; if the sign & is meant, or else the text that you want."


def _bare(source: Source, at: int) -> None:
    if source.is_full:
        return
    found = _BARE.match(source.text, at)
    is_number, name = (found[1], found[2]) if found else ("", "")
    if name and (is_number or name in ENTITIES):
        what = f"{short(f'&{is_number}{name}')} has no semicolon at its end"
        remedy = f"Write {short(f'&{is_number}{name};')}"
        if is_number and name[0] == "X":
            what, remedy = "the x of &#x...; is a small letter", f"Write &#x{short(name[1:])};"
    else:
        what, remedy = (
            "& begins an entity such as &lt; and cannot stand alone",
            "Write &amp; for the sign &.",
        )
        is_number = name = ""
    is_number_sign = source.text.startswith("&#", at)
    kind = FaultKind.BAD_REFERENCE if is_number_sign else FaultKind.BAD_CHARACTER
    source.fault(kind, at, at + 1 + len(is_number + name), what=what, remedy=remedy)
