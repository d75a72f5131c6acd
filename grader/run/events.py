"""What a checker process tells while it works: JSON objects, one a line, over a private pipe.

    {"event": "plan", "checks": [result, ...]}      which checks there are, in order
    {"event": "start", "index": 0}                  this one begins
    {"event": "result", "index": 0, "result": ...}  this one is decided; with `"fault": "..."`, what is said
                                                    instead if the reference solution fails there
    {"event": "broken", "text": "..."}              the checks themselves cannot run
    {"event": "end"}                                all is said

A pipe that closes without `end` is a checker that died; what it said before still counts.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field

from grader.errors import ResultError
from grader.results import MAX_CHECKS, CheckResult

MAX_LINE = 1_000_000
"""Longest event [bytes]; 500 titles and their JSON fit."""


@dataclass(slots=True)
class Transcript:
    """What is known of one run of checks so far."""

    plan: list[CheckResult] = field(default_factory=list)
    """Every check, in order, undecided."""
    results: dict[int, CheckResult] = field(default_factory=dict)
    """The decided ones, by their place in the plan."""
    faults: dict[int, str] = field(default_factory=dict)
    """What the message of a result is if the reference solution does not pass that check either."""
    running: int | None = None
    """The one that has begun and is not decided."""
    broken: str = ""
    """Why the checks cannot run; empty if they can."""
    ended: bool = False
    """Whether the checker said all it had to say."""

    def add(self, line: bytes) -> None:
        """Take one event.

        Raises:
            ResultError: It is no event, or does not fit those before it.
        """
        try:
            event = json.loads(line)
        except (ValueError, RecursionError) as error:
            raise ResultError(f"an event is not JSON: {error}") from error
        kind = event.get("event") if isinstance(event, dict) else None
        if kind == "plan":
            self._take_plan(event.get("checks"))
        elif kind == "start":
            self.running = self._index(event)
        elif kind == "result":
            self._take_result(event)
        elif kind == "broken":
            self.broken = self.broken or str(event.get("text"))  # the first is the cause
        elif kind == "end":
            self.ended = True
        else:
            raise ResultError(f"unknown event {kind!r}")

    def _take_plan(self, checks: object) -> None:
        if self.plan or not isinstance(checks, list) or len(checks) > MAX_CHECKS:
            raise ResultError("a second plan, or one that is no list")
        self.plan = [CheckResult.from_json(check) for check in checks]

    def _take_result(self, event: dict[str, object]) -> None:
        index = self._index(event)
        result = CheckResult.from_json(event.get("result"))
        planned = self.plan[index]
        if index in self.results or _identity(result) != _identity(planned):
            raise ResultError(f"the result of {planned.name} does not fit the plan")
        self.results[index] = result
        if event.get("fault"):
            self.faults[index] = str(event["fault"])
        self.running = None

    def _index(self, event: dict[str, object]) -> int:
        index = event.get("index")
        if not isinstance(index, int) or not 0 <= index < len(self.plan):
            raise ResultError("an event for a check that is not in the plan")
        return index


def _identity(check: CheckResult) -> tuple[object, ...]:
    return (check.name, check.title, check.max_points, check.hidden)
