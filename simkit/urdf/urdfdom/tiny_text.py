"""Text and values as TinyXML reads them: white space, entities, letters of several bytes.

Each letter of the text stands for a byte.
"""

from __future__ import annotations

import functools
import re

_SPACE = re.compile(r"[\t-\r ]*+")
_UTF8_SPACE = re.compile(r"(?:[\t-\r ]|\xef\xbb\xbf|\xef\xbf[\xbe\xbf])*+")
_ENTITIES = {"&amp;": "&", "&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'"}
_BEYOND_UNICODE = 0x110000


class LostError(Exception):
    """TinyXML is at the end of the text, or has lost its place in it, and says nothing yet."""


def behind_space(text: str, start: int, *, is_utf8: bool) -> int:
    """The place of the next thing that is not white space.

    Raises:
        LostError: The text was over already.
    """
    if start == len(text):
        raise LostError
    match = (_UTF8_SPACE if is_utf8 else _SPACE).match(text, start)
    assert match is not None  # it may be empty
    return match.end()


def skip_text(text: str, start: int, *, is_utf8: bool) -> int:
    """The place of the `<` behind text between two tags.

    Raises:
        LostError: There is none, or the text has an entity that TinyXML cannot read.
    """
    return quoted(text, start, "<", is_utf8=is_utf8)[1] - 1


def quoted(text: str, start: int, end: str, *, is_utf8: bool) -> tuple[str, int]:
    """A value up to the letter that ends it, with its entities replaced, and the place behind that letter.

    Raises:
        LostError: The letter does not come or is the last one, or an entity cannot be read.
    """
    plain = _plain(end, is_utf8)
    pieces: list[str] = []
    place = start
    while True:
        match = plain.match(text, place)
        assert match is not None  # it may be empty
        pieces.append(match.group())
        place = match.end()
        if text.startswith(end, place) and place + 1 < len(text):
            return "".join(pieces), place + 1
        if not text.startswith("&", place):
            raise LostError
        piece, place = _entity(text, place, is_utf8=is_utf8)
        pieces.append(piece)


@functools.cache
def _plain(end: str, is_utf8: bool) -> re.Pattern[str]:
    """Letters that stand for themselves; in UTF-8 the first byte of a letter takes its others along."""
    if not is_utf8:
        return re.compile(rf"[^&{end}]*+")
    return re.compile(
        rf"(?:[^&{end}\xc2-\xf4]++|[\xc2-\xdf][\s\S]|[\xe0-\xef][\s\S]{{2}}|[\xf0-\xf4][\s\S]{{3}})*+"
    )


def _entity(text: str, start: int, *, is_utf8: bool) -> tuple[str, int]:
    """What stands for an entity, and the place behind it; an `&` that begins none is dropped."""
    if text.startswith("&#", start) and start + 2 < len(text):
        return _number(text, start, is_utf8=is_utf8)
    for entity, letter in _ENTITIES.items():
        if text.startswith(entity, start):
            return letter, start + len(entity)
    return "", start + 1


def _number(text: str, start: int, *, is_utf8: bool) -> tuple[str, int]:
    """The letter of a number like `&#228;`. TinyXML goes to the next `;` and reads backwards from there."""
    end = text.find(";", start + 2)
    is_hexadecimal = text.startswith("x", start + 2)
    if end < 0:
        raise LostError
    digits = text[text.rindex("x" if is_hexadecimal else "#", start, end) + 1 : end]
    if not re.fullmatch("[0-9A-Fa-f]*" if is_hexadecimal else "[0-9]*", digits):
        raise LostError
    # The original's place value is an unsigned int, in which 16 to the 8th is 0.
    code = int(digits[-8:] or "0", 16 if is_hexadecimal else 10)
    if not is_utf8:
        return chr(code & 0xFF), end + 1
    if code >= _BEYOND_UNICODE:
        return "", end + 1
    return chr(code).encode("utf-8", "surrogatepass").decode("latin-1"), end + 1
