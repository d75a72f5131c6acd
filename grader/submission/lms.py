"""Whose file it is, by the names that learning management systems give to downloads.

Moodle: `Full Name_123_assignsubmission_file_/x.ipynb` or `Full Name_123_assignsubmission_file_x.ipynb`.
Canvas: `lastfirst_123_456_x.ipynb`, with `_LATE` before the numbers when late.
Gradescope and nbgrader make a folder per student, which needs no rule.
"""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass

MAX_NAME = 100
"""Longest name of a student [characters]."""
_MOODLE = re.compile(
    r"(?P<student>.+?)_(?P<number>\d+)_assignsubmission_file_?(?P<rest>.*)", re.DOTALL
)
_CANVAS = re.compile(
    r"(?P<student>[^\W\d_][^_/]*?)_(?:LATE_)?(?P<number>\d{3,})_\d{3,}_(?P<rest>.+)", re.DOTALL
)


@dataclass(frozen=True, slots=True, kw_only=True)
class LmsName:
    """A name of a folder or file, taken apart."""

    student: str
    number: str
    """The number that the system knows the student or hand-in by."""
    rest: str
    """What the student called the file; empty for a folder."""


def lms_name(name: str) -> LmsName | None:
    """The parts of a name that Moodle or Canvas gave; None for any other name."""
    found = _MOODLE.fullmatch(name) or _CANVAS.fullmatch(name)
    if found is None:
        return None
    return LmsName(
        student=student_name(found["student"]), number=found["number"], rest=found["rest"]
    )


def student_name(text: str) -> str:
    """A name fit for tables: one line, no signs that steer a terminal or turn the text."""
    text = text.encode("utf-8", "replace").decode("utf-8")
    kept = "".join(c if unicodedata.category(c)[0] not in "CZ" else " " for c in text)
    return " ".join(kept.split())[:MAX_NAME] or "unnamed"
