"""Node side: an error of a script, without our own frames."""

from __future__ import annotations

import traceback
from pathlib import Path
from typing import Any, TextIO

OUR_FOLDER = str(Path(__file__).resolve().parents[2])


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
    lines += traceback.format_exception_only(error)
    stream.write("".join(lines))


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
        text = "".join(traceback.format_exception_only(error)).strip()
    return {"kind": "exception", "text": text[:2000], **place}
