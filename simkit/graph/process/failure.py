"""What went wrong in a node process, in words for the student."""

from __future__ import annotations

import signal
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any


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
