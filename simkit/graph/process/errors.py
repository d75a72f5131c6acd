"""Node side: an error of a script, without our own frames."""

from __future__ import annotations

import inspect
import traceback
from pathlib import Path
from typing import Any, TextIO

OUR_FOLDER = str(Path(__file__).resolve().parents[2])
LONGEST_TEXT = 2000
"""Longest description of an error [characters]."""


def student_frames(error: BaseException) -> list[traceback.FrameSummary]:
    """The frames of an error's traceback that are not ours, outermost first."""
    return [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if not frame.filename.startswith((OUR_FOLDER, "<frozen"))
    ]


def print_traceback(error: BaseException, stream: TextIO) -> None:
    """Print an error as Python does, without our own frames."""
    lines = ["Traceback (most recent call last):\n", *traceback.format_list(student_frames(error))]
    if isinstance(error, SyntaxError) and not student_frames(error):
        lines = []
    stream.write("".join(lines) + _last_words(error) + "\n")


def describe(error: BaseException, script: str) -> dict[str, Any]:
    """What went wrong, and where in the student's files."""
    if isinstance(error, SyntaxError) and error.filename == script:
        place: dict[str, Any] = {"file": error.filename, "line": error.lineno, "function": None}
        text = f"{type(error).__name__}: {error.msg}"
    else:
        frames = student_frames(error)
        last = frames[-1] if frames else None
        place = {
            "file": last.filename if last else script,
            "line": last.lineno if last else None,
            "function": last.name if last else None,
        }
        text = _last_words(error).strip()
    return {"kind": "exception", "text": _shortened(text), **place}


def _last_words(error: BaseException) -> str:
    """What stands below the frames of a traceback: the error, its notes, and the hint that it carries."""
    text = "".join(traceback.format_exception_only(error)).rstrip("\n")
    hint = inspect.getattr_static(error, "hint", None)
    # A hint may be among the notes already, for tracebacks that Python prints.
    if isinstance(hint, str) and hint and f"hint: {hint}" not in text:
        text += f"\nhint: {hint}"
    return text


def _shortened(text: str) -> str:
    """A long text without its middle: the error stands first, and what to do about it last."""
    if len(text) <= LONGEST_TEXT:
        return text
    half = LONGEST_TEXT // 2 - 10
    return f"{text[:half]}\n...\n{text[-half:]}"
