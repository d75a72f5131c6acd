"""Numbers on a command line, read as programs in C read them."""

from __future__ import annotations

import re

_NUMBER = re.compile(r"\s*[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?")


def leading_number(text: str) -> float:
    """The number that a text begins with; 0 if it begins with none.

    Source:
        `atof` of C, with which the programs of tf read their arguments.
    """
    found = _NUMBER.match(text)
    return float(found[0]) if found else 0.0


def is_number(text: str) -> bool:
    """Whether the whole text is one number."""
    return _NUMBER.fullmatch(text) is not None
