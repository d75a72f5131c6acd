"""What a world, a controller or a node said of itself: the log of a simulation, as evidence of a check."""

from __future__ import annotations

from grader.errors import CheckFailed
from simkit import Simulation
from simkit.graph import LogLevel

_NEAR = 3
"""The hint to an error is among so many lines behind it."""


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
