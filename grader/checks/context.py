"""What the checks of one run are about: given by the checker process, seen by the plugin."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from grader.exercises import Exercise
from grader.sandbox import Sandbox
from grader.submission import Submission

Event = dict[str, object]
"""Something that has happened, as a JSON object; `grader.run.events` has the list."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CheckContext:
    """One submission to one exercise, and where its results go."""

    exercise: Exercise
    submission: Submission
    sandbox: Sandbox
    folder: Path
    """Empty folder of this run, for the student's files; removed by the runner."""
    report: Callable[[Event], None]
    """Takes each event at once, so that a crash loses none of those before it."""
    only_list: bool = False
    """Whether to say which checks there are, and run none."""
    for_author: bool = False
    """Whether results are for the author of the checks: with logs, and faults of checks undisguised."""


CONTEXT: pytest.StashKey[CheckContext] = pytest.StashKey()


def context_of(config: pytest.Config) -> CheckContext:
    """The context of this pytest run.

    Raises:
        pytest.UsageError: The checks were not started by the grader.
    """
    context = config.stash.get(CONTEXT, None)
    if context is None:
        raise pytest.UsageError("checks are run by `grader check` and `grader grade`")
    return context
