"""From what happened in a check to what the student reads."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

from grader.checks.expect import explanation
from grader.checks.nodes import NodeWatch, Trouble
from grader.checks.values import bounded
from grader.errors import CheckFailed
from grader.results import Status
from simkit.errors import SimkitError


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """How one check came out."""

    status: Status
    message: str = ""
    hint: str = ""
    fault: str = ""
    """What to say in its place if the reference solution fails in this check, too: the fault is then ours."""


def verdict_of(
    error: BaseException | None, watch: NodeWatch, *, for_author: bool = False
) -> Verdict:
    """The verdict of a check that has just run.

    A check that passed has passed, whatever its nodes did; what they were refused is said. One
    that did not begins with what happened in a node of the student, since that is the cause, and
    what was expected the effect.

    An error of the check itself is the student's where a node or launch file of theirs had run: the
    check met a graph that no solution leaves. What grades can ask the reference solution about it.

    Args:
        error: What the check raised; None if it returned.
        watch: The nodes that it started.
        for_author: Whether an error of the check itself is told also where a node of the student broke down.
    """
    if error is None:
        return Verdict(status=Status.PASSED, message=bounded(watch.refusal()))
    if isinstance(error, pytest.skip.Exception):
        return Verdict(status=Status.SKIPPED, message=bounded(str(error)))
    trouble = watch.trouble()
    if isinstance(error, SimkitError):
        # No such frame, no message on that topic: the graph is as the student's nodes left it.
        error = CheckFailed(str(error), hint=str(getattr(error, "hint", "")))
    if isinstance(error, CheckFailed):
        return _failed(error, trouble, (watch.unmatched_topics(), watch.early_ends()))
    if trouble is not None and not for_author:
        return Verdict(status=trouble.status, message=bounded(trouble.message))
    ran = watch.started()
    if not ran or for_author or not isinstance(error, Exception) or isinstance(error, OSError):
        return Verdict(status=Status.INFRASTRUCTURE, message=our_fault(error))
    return Verdict(
        status=Status.FAILED,
        message=f"this check ended early, in a state that {ran} has brought about: {_described(error)}",
        hint="The solution of this exercise does not bring it about. What does your node do that was not asked for? "
        "Perhaps it publishes too early or with another type, or takes a name that another node has.",
        fault=our_fault(error),
    )


def _failed(error: CheckFailed, trouble: Trouble | None, notes: Sequence[str]) -> Verdict:
    parts = [trouble.message if trouble else "", explanation(error), *notes]
    return Verdict(
        status=trouble.status if trouble else Status.FAILED,
        message=bounded("\n".join(part.strip() for part in parts if part)),
        # The hint is about the expectation; where a node broke down, its own message is the one to read.
        hint=bounded(error.hint) if trouble is None or trouble.status is Status.FAILED else "",
    )


def our_fault(error: BaseException) -> str:
    """One line about an error in our own code, with the innermost place that is known."""
    return f"this check could not decide, which is not your fault: {_described(error)}"


def _described(error: BaseException) -> str:
    place = ""
    trace = error.__traceback__
    while trace is not None:
        place = f" ({Path(trace.tb_frame.f_code.co_filename).name}:{trace.tb_lineno})"
        trace = trace.tb_next
    text = bounded(f"{type(error).__name__}: {error}".rstrip(": "), 300)
    return f"{text}{place}"
