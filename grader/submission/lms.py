"""Whose file it is, by the names that learning management systems give to downloads.

Moodle: `Full Name_123_assignsubmission_file_/x.ipynb` or `Full Name_123_assignsubmission_file_x.ipynb`.
Canvas: `lastfirst_123_456_x.ipynb`, with `_LATE` before the numbers when late.
Gradescope and nbgrader make a folder per student, which needs no rule.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from grader.submission.labels import label

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
    return LmsName(student=label(found["student"]), number=found["number"], rest=found["rest"])
