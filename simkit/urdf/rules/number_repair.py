"""What somebody meant who wrote `0, 0, 0.05`, `5cm` or `pi/2` where numbers stand with spaces between them."""

from __future__ import annotations

import math
import re

from simkit.urdf.rules.values import number_text, read_number

_UNITS = {
    **{"m": 1.0, "cm": 0.01, "mm": 0.001},
    **{"kg": 1.0, "g": 0.001, "rad": 1.0, "rads": 1.0, "n": 1.0, "nm": 1.0, "f": 1.0, "m/s": 1.0},
    **{"deg": math.pi / 180, "degrees": math.pi / 180, "°": math.pi / 180, "rad/s": 1.0},
}
_WITH_UNIT = r"([+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?)\s*([a-z°/]{1,8})"
_PI = r"([+-]?)(?:([0-9.]+)\s*\*?\s*)?(?:math\.|m_)?(?:pi|π)(?:\s*/\s*([0-9.]+))?"
_DASHES = str.maketrans({"−": "-", "–": "-", "—": "-", "\u00a0": " ", "\t": " ", "\n": " "})
_LONGEST = 200


def mended(text: str, count: int) -> str | None:
    """So many numbers as they should have been written; None if it cannot be told what was meant.

    Args:
        text: What is written.
        count: How many numbers there should be.
    """
    if len(text) > _LONGEST:
        return None
    text = text.translate(_DASHES).strip().strip("()[]{}\"'").strip()
    if count == 1:
        return _one(text)
    for words in (text.split(), re.split(r"[\s,;]+", text.strip(" ,;"))):
        numbers = [number for word in words if (number := _one(word)) is not None]
        if len(numbers) == len(words) == count:
            return " ".join(numbers)
    return None


def _one(word: str) -> str | None:
    word = word.strip().rstrip(",;").lower()
    for candidate in (word, word.replace(",", "."), word.replace("o", "0")):
        if read_number(candidate) is not None:
            return candidate
    return _with_unit(word) or _of_pi(word)


def _with_unit(word: str) -> str | None:
    match = re.fullmatch(_WITH_UNIT, word)
    number = None if match is None else read_number(match[1])
    if match is None or number is None or match[2] not in _UNITS:
        return None
    return number_text(number * _UNITS[match[2]])


def _of_pi(word: str) -> str | None:
    match = re.fullmatch(_PI, word)
    if match is None:
        return None
    factor, part = read_number(match[2] or "1"), read_number(match[3] or "1")
    if factor is None or not part:
        return None
    return f"{match[1].replace('+', '')}{factor * math.pi / part:.4f}"
