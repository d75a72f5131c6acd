"""What went wrong in a node process: the error as its script raised it, and in words for the student."""

from __future__ import annotations

import inspect
import signal
import traceback
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from simkit.graph.process.remedies import remedy_of

OUR_FOLDER = str(Path(__file__).resolve().parents[2])
LONGEST_TEXT = 2000
"""Longest description of an error [characters]."""

# -- node side


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
        text = _with_hint(f"{type(error).__name__}: {error.msg}{_line_of(error)}", error)
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
    return _with_hint("".join(traceback.format_exception_only(error)).rstrip("\n"), error)


def _line_of(error: SyntaxError) -> str:
    """The line of code at which Python gave up, below its error."""
    return f"\n    {error.text.strip()}" if error.text and error.text.strip() else ""


def _with_hint(text: str, error: BaseException) -> str:
    hint = inspect.getattr_static(error, "hint", None) or remedy_of(error)
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


# -- graph side


@dataclass(frozen=True, slots=True, kw_only=True)
class NodeFailure:
    """Why a node process ended although it should not have."""

    kind: str
    """`exception`, `stuck`, `exit`, `killed`, `output`, `protocol` or `start`."""
    text: str
    """One sentence, or the last line of the traceback."""
    file: str | None = None
    """The student's file."""
    line: int | None = None
    """Line in it."""
    function: str | None = None
    """Function in it."""

    def __str__(self) -> str:
        where = f"{self.file}:{self.line}: " if self.file and self.line else ""
        return where + self.text


def from_exit_record(value: Any) -> NodeFailure | None:
    """The failure that a node reported of itself; whatever it says, only short strings come out."""
    if not isinstance(value, dict):
        return None
    line = value.get("line")
    return NodeFailure(
        kind="exception",
        text=str(value.get("text"))[:2000],
        file=str(value["file"])[:400] if value.get("file") else None,
        line=line if isinstance(line, int) else None,
        function=str(value["function"])[:200] if value.get("function") else None,
    )


def stuck(stack: Sequence[tuple[str, int, str]], allowance: float) -> NodeFailure:
    """A node that neither blocked nor ended; `stack` is innermost first."""
    # A script is compiled under a relative path; what it calls in a library has an absolute one.
    file, line, function = next(
        (
            frame
            for frame in stack
            if not frame[0].startswith("<") and not Path(frame[0]).is_absolute()
        ),
        (None, None, None),
    )
    return NodeFailure(
        kind="stuck",
        text=(
            f"the script computed for {allowance:g} s without sleeping or waiting; "
            "a loop needs rate.sleep(), rospy.sleep() or `while not rospy.is_shutdown()`"
        ),
        file=file,
        line=line,
        function=function,
    )


def flooded(limit: int) -> NodeFailure:
    """A node that printed too much."""
    return NodeFailure(
        kind="output",
        text=f"the script printed more than {limit // 1024} KiB and was stopped; print less, or only now and then",
    )


def overwhelmed() -> NodeFailure:
    """A node for which more waits than it can be given."""
    return NodeFailure(
        kind="output", text="more than 64 MiB of answers wait for this node at one instant"
    )


def unreadable(reason: str) -> NodeFailure:
    """A node that does not speak the protocol."""
    return NodeFailure(
        kind="protocol", text=f"the script wrote on its private line to the graph: {reason}"
    )


def abrupt_end(exit_code: int | None) -> NodeFailure:
    """A node that ended without a word."""
    if exit_code is None:
        return NodeFailure(kind="killed", text="the process has vanished")
    if exit_code >= 0:
        return NodeFailure(
            kind="exit",
            text=f"the process ended at once with exit code {exit_code}, without leaving the graph "
            "(os._exit, or a crash in C code)",
        )
    return NodeFailure(kind="killed", text=_signal_text(-exit_code))


def _signal_text(number: int) -> str:
    try:
        name = signal.Signals(number).name
    except ValueError:
        name = f"signal {number}"
    reason = {
        "SIGXCPU": "it used more processor time than it may",
        "SIGXFSZ": "it wrote a larger file than it may",
        "SIGKILL": "something killed it: itself, or the system for want of memory",
        "SIGSEGV": "it crashed in C code",
    }.get(name, "a signal ended it")
    return f"the process was ended by {name}: {reason}"
