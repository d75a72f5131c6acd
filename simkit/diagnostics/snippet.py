"""A line of a file with a piece of it underlined, as a terminal shows it."""

from __future__ import annotations

from simkit.xml import Span

_TAB = "    "
_SPACES = dict.fromkeys("\u00a0\u202f\u2007\u3000", "\u2423")
_CUT = "..."


def visible(text: str) -> str:
    """A text as it can be seen: a tab as spaces, a control character as its sign, an odd space as `␣`.

    Nothing in it moves a terminal, or turns the order of its letters around.
    """
    return text if text.isprintable() else "".join(map(_visible, text))


def _visible(letter: str) -> str:
    if letter.isprintable():
        return letter
    if letter == "\t":
        return _TAB
    code = ord(letter)
    if code < 0x20 or code == 0x7F:
        return "\u2421" if code == 0x7F else chr(0x2400 + code)
    return _SPACES.get(letter, "\ufffd")


def width(text: str) -> int:
    """How many columns of a terminal a visible text takes."""
    return len(text) if text.isascii() else sum(map(_width, text))


def _width(letter: str) -> int:
    if letter.isascii():
        return 1
    import unicodedata  # for the few files that have such letters

    if unicodedata.combining(letter):
        return 0
    return 2 if unicodedata.east_asian_width(letter) in "WF" else 1


def snippet(line: str, span: Span, room: int) -> tuple[str, str]:
    """A line as a terminal shows it, and a second line that underlines a piece of it.

    Of a long line the part around the piece is shown, with `...` for the rest.

    Args:
        line: The line of the file.
        span: The piece.
        room: Columns that there are.
    """
    begin = min(span.column - 1, len(line))
    first, last = _shown_part(line, begin, room)
    end = min(begin + span.length, last)
    before = (_CUT if first else "") + visible(line[first:begin])
    piece = visible(line[begin:end])
    behind = visible(line[end:last]) + (_CUT if last < len(line) else "")
    return before + piece + behind, " " * width(before) + "^" + "~" * (width(piece) - 1)


def _shown_part(line: str, begin: int, room: int) -> tuple[int, int]:
    """Index of the first letter that is shown, and of the one behind the last."""
    before = line[max(0, begin - room) : begin][::-1]
    first = 0
    if _fitting(before, room // 2) < begin:
        first = begin - _fitting(before, room // 3)
    room -= len(_CUT) if first else 0
    fitting = first + _fitting(line[first : first + room + 1], room)
    if fitting < len(line):
        fitting = first + _fitting(line[first : first + room], room - len(_CUT))
    return first, fitting


def _fitting(letters: str, room: int) -> int:
    """How many of the letters, from the first one on, take no more than `room` columns."""
    taken = 0
    for count, letter in enumerate(letters):
        taken += width(_visible(letter))
        if taken > room:
            return count
    return len(letters)
