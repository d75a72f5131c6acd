"""Bytes to JSON values without trusting them: encoding, size and depth are settled first.

The parser of the standard library recurses with the nesting of its input. Brackets are counted
before it starts, so that it never meets a depth it could stumble over.
"""

from __future__ import annotations

import codecs
import json
import re

from grader.errors import SubmissionError

MAX_DEPTH = 100
"""Deepest nesting of lists and objects; a notebook's own is below 10, an output's below 50."""
MAX_VALUES = 4_000_000
"""Most values of a file; bounds the memory that its parsed form takes."""

_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),  # before UTF-16: its mark begins with that one's
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_BRACKETS_ONLY = re.compile(r"[^\[\]{}]+")


def parse_json(data: bytes) -> object:
    """The JSON value in `data`; NaN and Infinity are let through, as Jupyter writes them.

    Raises:
        SubmissionError: It is not JSON, nested too deeply, or holds too many values.
    """
    text = decode(data)
    _require_shallow(text)
    try:
        return json.loads(text)
    except (ValueError, RecursionError) as error:
        raise SubmissionError(f"is not a notebook: not JSON ({error})") from error


def decode(data: bytes) -> str:
    """Text of a file: UTF-8, -16 or -32, with or without a mark; wrong bytes become a sign."""
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return data[len(mark) :].decode(encoding, "replace")
    return data.decode(json.detect_encoding(data), "replace")


def _require_shallow(text: str) -> None:
    # Escaped backslashes go first, then escaped quotes; what is left between quotes is a string.
    bare = re.sub(r'"[^"]*"', "", text.replace("\\\\", "").replace('\\"', ""))
    if bare.count(",") + bare.count("[") + bare.count("{") > MAX_VALUES:
        raise SubmissionError(
            f"holds more than {MAX_VALUES} values; clear the outputs"
            " (Edit > Clear Outputs of All Cells) and save"
        )
    brackets = _BRACKETS_ONLY.sub("", bare).replace("{", "[").replace("}", "]")
    for _ in range(MAX_DEPTH):
        if not brackets:
            return
        brackets = brackets.replace("[]", "")
    if "[]" in brackets:
        raise SubmissionError(f"is not a notebook: nested more than {MAX_DEPTH} deep")
    if brackets:
        raise SubmissionError("is not a notebook: not JSON (cut off, or its brackets do not pair)")
