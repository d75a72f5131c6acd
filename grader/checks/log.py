"""What a world, a controller or a node said of itself: the log of a simulation, as evidence of a check."""

from __future__ import annotations

from grader.checks.values import bounded
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.graph import LogLevel

_NEAR = 3
"""The hint to an error is among so many lines behind it."""
_MOST = 8
"""Lines of a log that an author reads."""
_LONGEST = 400
"""Characters of one of them."""


def log_of(sim: Simulation | None) -> str:
    """The first errors and warnings of a simulation, each once, with the hints behind them, a line each."""
    lines: dict[str, None] = {}
    for record in [] if sim is None else sim.log:
        is_hint = record.text.startswith("hint: ") and bool(lines)
        if is_hint or record.level >= LogLevel.WARN:
            text = " ".join(bounded(record.text, _LONGEST).split())
            lines[text if is_hint else f"{record.level.name} {record.node}: {text}"] = None
    return "\n".join(list(lines)[:_MOST])


def with_complaint(failure: CheckFailed, sim: Simulation) -> CheckFailed:
    """The failure, with the first thing that Gazebo or a controller's spawner found wrong below it."""
    said = complaint(sim)
    if not said:
        return failure
    return CheckFailed(
        f"{failure.message}\nits log says: {said}",
        expected=failure.expected,
        actual=failure.actual,
        hint=failure.hint,
    )


def complaint(sim: Simulation) -> str:
    """The first error on rosout, with the hint that follows it; the first refusal of a warning else; or nothing."""
    records = [one for one in sim.log if one.node != "/simkit"]
    for number, record in enumerate(records):
        is_refusal = record.level == LogLevel.WARN and "Dropping all" in record.text
        if record.level < LogLevel.ERROR and not is_refusal:
            continue
        following = records[number + 1 : number + 1 + _NEAR]
        hints = [one.text for one in following if one.text.startswith("hint: ")]
        return " ".join(" ".join([record.text, *hints[:1]]).split())
    return ""
