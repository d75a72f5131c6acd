"""Numbers as a URDF file writes them, and texts of a file as a message shows them."""

from __future__ import annotations

from collections.abc import Iterable

from simkit.geometry import Vector
from simkit.urdf.model import Rgba
from simkit.urdf.urdfdom.numbers import to_double

_SHOWN_LETTERS = 60
_SHOWN_DIGITS = 6


def read_number(text: str | None) -> float | None:
    """The number that `text` is, as urdfdom reads it, white space at its ends aside; None if it is none."""
    return None if text is None else to_double(text.strip(" "))


def read_numbers(text: str | None, count: int) -> tuple[float, ...] | None:
    """So many numbers with spaces between them; None if `text` is anything else."""
    words = [] if text is None else [word for word in text.split(" ") if word]
    numbers = [number for word in words[: count + 1] if (number := read_number(word)) is not None]
    return tuple(numbers) if len(words) == len(numbers) == count else None


def read_vector(text: str | None) -> Vector | None:
    """Three numbers."""
    numbers = read_numbers(text, 3)
    return None if numbers is None else (numbers[0], numbers[1], numbers[2])


def read_rgba(text: str | None) -> Rgba | None:
    """Four numbers, of any size."""
    numbers = read_numbers(text, 4)
    return None if numbers is None else (numbers[0], numbers[1], numbers[2], numbers[3])


def number_text(number: float) -> str:
    """A number for people: six digits, no needless zeros, no `-0`."""
    return f"{number + 0.0:.{_SHOWN_DIGITS}g}".replace("e-0", "e-").replace("e+0", "e")


def numbers_text(numbers: Iterable[float]) -> str:
    """Several numbers for people, as an attribute would hold them."""
    return " ".join(number_text(number) for number in numbers)


def shown(text: str) -> str:
    """A text of the file for a message: on one line, and not too long."""
    text = " ".join(text[: 4 * _SHOWN_LETTERS].split())
    return text if len(text) <= _SHOWN_LETTERS else text[: _SHOWN_LETTERS - 3] + "..."
