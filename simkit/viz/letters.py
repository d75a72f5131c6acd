"""How much room text takes, without asking a font: the same on every machine."""

from __future__ import annotations

import unicodedata
from typing import Final

_ASCII: Final = (
    *(318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337),
    *(636, 636, 636, 636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531),
    *(1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656, 557, 863, 748, 787),
    *(603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500),
    *(500, 613, 635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612),
    *(635, 635, 411, 521, 392, 634, 592, 818, 592, 592, 525, 636, 337, 636, 838),
)
"Widths of the letters from space to tilde in DejaVu Sans [1/1000 of the size]; most fonts need less."

_OTHER: Final = 1.1
_WIDE: Final = 1.4


def text_width(text: str, size: float) -> float:
    """Room for a line of text [px], rather too much than too little.

    Args:
        text: The line.
        size: Size of the letters [px].
    """
    return size * sum(_letter_width(letter) for letter in text)


def printable(text: str) -> str:
    """The text without control characters, which no XML file may hold."""
    return "".join(
        letter if letter.isprintable() else "\N{REPLACEMENT CHARACTER}" for letter in text
    )


def shortened(text: str, limit: int) -> str:
    """The text, made printable; the middle of a long one is left out.

    Args:
        text: Any text.
        limit: At most so many letters.
    """
    text = printable(text)
    if len(text) <= limit:
        return text
    tail = (limit - 1) // 2
    return f"{text[: limit - 1 - tail]}\N{HORIZONTAL ELLIPSIS}{text[-tail:]}"


def wrapped(text: str, *, size: float, width: float) -> list[str]:
    """Lines of a text that fit into a width.

    Args:
        text: Words with spaces between them; a word that is too long gets a line of its own.
        size: Size of the letters [px].
        width: Room [px].
    """
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and text_width(longer, size) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def _letter_width(letter: str) -> float:
    code = ord(letter)
    if 32 <= code < 127:
        return _ASCII[code - 32] / 1000
    return _WIDE if unicodedata.east_asian_width(letter) in "WF" else _OTHER
