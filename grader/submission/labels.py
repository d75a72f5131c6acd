"""Names of files and people as they may stand in a sentence or a table."""

from __future__ import annotations

import unicodedata


def label(text: str, limit: int = 100) -> str:
    """A text on one line, without signs that steer a terminal or turn the direction of reading.

    Args:
        text: Chosen by a student, or by anybody else.
        limit: Longest result [characters].
    """
    text = text[: 4 * limit].encode("utf-8", "replace").decode("utf-8")
    kept = "".join(c if unicodedata.category(c)[0] not in "CZ" else " " for c in text)
    return " ".join(kept.split())[:limit] or "unnamed"
