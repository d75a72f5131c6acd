"""Show a value to a student: short, in one line, and never able to steer a terminal."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Sequence
from typing import Any

VALUE_LENGTH = 120
"""Longest value shown in a message [characters]."""
TEXT_LENGTH = 2000
"""Longest message [characters]."""
_DIGITS = 6
_ITEMS = 12


def shown(value: Any, *, unit: str = "", frame: str = "") -> str:
    """A value as a student reads it, e.g. `(1.5, 0, 0) m in frame world`.

    Args:
        value: A literal, a number, or a row of them.
        unit: Unit of every number, e.g. "m".
        frame: Name of the frame that it is expressed in.
    """
    text = _cut(clean(_plain(value)), VALUE_LENGTH)
    text += f" {unit}" if unit else ""
    return text + (f" in frame {frame}" if frame else "")


def _plain(value: Any) -> str:
    if isinstance(value, bool | str | bytes) or value is None:
        return repr(value[: 4 * VALUE_LENGTH] if isinstance(value, str | bytes) else value)
    if isinstance(value, float | int):
        return _number(value)
    if isinstance(value, list | tuple):
        return _row(value)
    return repr(value)


def _number(value: float) -> str:
    if isinstance(value, int):
        return str(value) if abs(value) < 10**15 else f"a whole number of {value.bit_length()} bits"
    if not math.isfinite(value):
        return str(value)
    text = f"{value:.{_DIGITS}g}"
    return "0" if text == "-0" else text


def _row(value: Sequence[Any]) -> str:
    items = [_plain(item) for item in value[:_ITEMS]]
    if len(value) > _ITEMS:
        items.append(f"... {len(value)} in all")
    return ("[{}]" if isinstance(value, list) else "({})").format(", ".join(items))


def clean(text: str) -> str:
    """The text without characters that steer a terminal or turn the reading direction."""
    return "".join(c if c in "\n\t" or _printable(c) else "\N{REPLACEMENT CHARACTER}" for c in text)


def _printable(character: str) -> bool:
    return unicodedata.category(character) not in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp")


def bounded(text: str, limit: int = TEXT_LENGTH) -> str:
    """The text, clean and cut to a length that people read."""
    return _cut(clean(text[: limit + 1]), limit)


def _cut(text: str, limit: int) -> str:
    return text if len(text) <= limit else f"{text[: limit - 2].rstrip()} …"
