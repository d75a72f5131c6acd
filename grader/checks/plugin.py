"""The pytest plugin that turns pytest functions into checks of a student's work.

Loaded by name in the checker process (`-p grader.checks.plugin`), and nowhere else. It says which
checks there are, then tells of each one as soon as it is known; it decides nothing by what pytest
prints or returns.
"""

from __future__ import annotations

import inspect
from collections.abc import Generator

import pytest

from grader.checks.context import CheckContext, context_of
from grader.checks.fixtures import WATCH
from grader.checks.log import log_of
from grader.checks.marks import needed_by, points_of
from grader.checks.nodes import NodeWatch
from grader.checks.verdict import Verdict, verdict_of
from grader.checks.workspace import close_workspace, workspace_of
from grader.results import CheckResult, Status

pytest_plugins = ["grader.checks.fixtures"]

_INDEX: pytest.StashKey[int] = pytest.StashKey()
_RESULTS: pytest.StashKey[dict[str, CheckResult]] = pytest.StashKey()


def pytest_configure(config: pytest.Config) -> None:
    """Make the marks known."""
    config.addinivalue_line("markers", "points(number): what the check is worth")
    config.addinivalue_line("markers", "after(names): checks that must have passed before")
    config.stash[_RESULTS] = {}


def pytest_sessionstart(session: pytest.Session) -> None:
    """Start what the student's nodes come from, if there are any: it gets ready while the checks are read."""
    context = context_of(session.config)
    if not context.only_list and any(file.endswith(".py") for file in context.submission.files):
        workspace_of(session.config).warm_up()


def pytest_unconfigure(config: pytest.Config) -> None:
    """End the student's nodes."""
    close_workspace(config)


@pytest.hookimpl(trylast=True)
def pytest_collection_finish(session: pytest.Session) -> None:
    """Say which checks there are, in the order of the files."""
    context = context_of(session.config)
    _require_sound(session.items)
    for index, item in enumerate(session.items):
        item.stash[_INDEX] = index
        item.stash[WATCH] = NodeWatch()
    checks = [_result(item, context, Verdict(status=Status.SKIPPED)) for item in session.items]
    context.report({"event": "plan", "checks": [check.to_json() for check in checks]})
    if context.only_list:
        session.items.clear()


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Begin a check, unless one that it builds on did not pass."""
    context_of(item.config).report({"event": "start", "index": item.stash[_INDEX]})
    results = item.config.stash[_RESULTS]
    for name in needed_by(item):
        for result in results.values():
            if _is_called(result.name, name) and result.status is not Status.PASSED:
                pytest.skip(f"it builds on another check that did not pass: {result.title}")


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Tell of a check when its function has run, or could not."""
    report = yield
    if call.when == "call" or (call.when == "setup" and call.excinfo is not None):
        error = call.excinfo.value if call.excinfo is not None else None
        context = context_of(item.config)
        watch = item.stash[WATCH]
        verdict = verdict_of(error, watch, for_author=context.for_author)
        shows_log = context.for_author and verdict.status is not Status.PASSED
        log = log_of(watch.simulation) if shows_log else ""
        result = _result(item, context, verdict, log=log)
        item.config.stash[_RESULTS][item.name] = result
        event = {"event": "result", "index": item.stash[_INDEX], "result": result.to_json()}
        context.report(event | ({"fault": verdict.fault} if verdict.fault else {}))
    return report


def _result(
    item: pytest.Item, context: CheckContext, verdict: Verdict, *, log: str = ""
) -> CheckResult:
    points = points_of(item)
    return CheckResult(
        name=item.name,
        title=_title(item),
        status=verdict.status,
        points=points if verdict.status is Status.PASSED else 0.0,
        max_points=points,
        hidden=item.path == context.exercise.hidden_checks,
        message=_without_folder(verdict.message, context),
        hint=verdict.hint,
        log=_without_folder(log, context),
    )


def _title(item: pytest.Item) -> str:
    """The sentence of a check: the first paragraph of its docstring."""
    text = inspect.getdoc(getattr(item, "obj", None)) or ""
    sentence = " ".join(text.split("\n\n")[0].split())
    return sentence or item.name.removeprefix("test_").replace("_", " ")


def _without_folder(text: str, context: CheckContext) -> str:
    # A temporary folder has another name at each run, and means nothing to a student.
    return text.replace(f"{context.folder / 'work'}/", "").replace(f"{context.folder}/", "")


def _is_called(check: str, name: str) -> bool:
    """Whether a check has this name; one of many inputs has them in brackets behind it."""
    return check == name or check.startswith(f"{name}[")


def _require_sound(items: list[pytest.Item]) -> None:
    """Refuse checks that the gradebook could not tell apart, or that build on later ones."""
    seen: set[str] = set()
    for item in items:
        if item.name in seen:
            raise pytest.UsageError(f"two checks are named {item.name}; each needs its own name")
        for name in needed_by(item):
            if not any(_is_called(other, name) for other in seen):
                raise pytest.UsageError(
                    f"{item.name} is after {name}, which does not come before it"
                )
        seen.add(item.name)
