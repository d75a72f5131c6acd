"""How much room text takes, without asking a font: the same on every machine; and where there is room for names."""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from typing import Final

from simkit.viz.draw.drawing import Point

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


_BELOW = 10.0
"A name is a little below its point, where no axis that points up hides it [px]."
_STEPS = (0, -1, 1, -2, 2, -3, 3, -4, 4, 5, 6, 7, 8)
"Tried places, in lines below the point."


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


def abbreviated(text: str, limit: int) -> str:
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


def label_places(
    anchors: Sequence[Point], *, widths: Sequence[float], height: float, size: Point
) -> list[Point | None]:
    """Left end of each name's middle line [px]; None for a name that has no room.

    Args:
        anchors: The points.
        widths: Room for each name [px].
        height: Room for a line [px].
        size: Width and height of the picture, which no name should leave.
    """
    taken: list[tuple[float, float, float]] = []
    places: list[Point | None] = []
    for (x, y), width in zip(anchors, widths, strict=True):
        right, left = x + 9, x - 9 - width
        sides = (right, left) if right + width <= size[0] else (left, right)
        tried = [(side, y + _BELOW + step * height) for step in _STEPS for side in sides]
        seen = [place for place in tried if height / 2 <= place[1] <= size[1] - height / 2]
        free = (place for place in seen if not _hits(place, width, height, taken))
        place = next(free, None)
        if place is not None:
            taken.append((*place, width))
        places.append(place)
    return places


def _letter_width(letter: str) -> float:
    code = ord(letter)
    if 32 <= code < 127:
        return _ASCII[code - 32] / 1000
    return _WIDE if unicodedata.east_asian_width(letter) in "WF" else _OTHER


def _hits(
    place: Point, width: float, height: float, taken: Sequence[tuple[float, float, float]]
) -> bool:
    left, middle = place
    return any(
        left < other_left + other_width
        and other_left < left + width
        and abs(middle - other_middle) < height
        for other_left, other_middle, other_width in taken
    )
