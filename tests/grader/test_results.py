from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.errors import ResultError
from grader.results import MAX_TEXT, CheckResult, ExerciseResult, Status, status_of


def check(status: Status = Status.PASSED, **changes: Any) -> CheckResult:
    fields: dict[str, Any] = {
        "name": f"test_{status}",
        "title": "The turtle moves.",
        "status": status,
        "points": 2.0 if status is Status.PASSED else 0.0,
        "max_points": 2.0,
    }
    return CheckResult(**{**fields, **changes})


S = Status


@pytest.mark.parametrize(
    ("statuses", "expected"),
    [
        ([], S.INFRASTRUCTURE),
        ([S.PASSED, S.PASSED], S.PASSED),
        ([S.PASSED, S.FAILED], S.FAILED),
        ([S.PASSED, S.NOT_ATTEMPTED], S.FAILED),
        ([S.PASSED, S.SKIPPED], S.FAILED),
        ([S.NOT_ATTEMPTED, S.SKIPPED], S.NOT_ATTEMPTED),
        ([S.NOT_ATTEMPTED], S.NOT_ATTEMPTED),
        ([S.SKIPPED, S.SKIPPED], S.SKIPPED),
        ([S.ERROR, S.SKIPPED], S.ERROR),
        ([S.ERROR, S.TIMEOUT, S.FAILED], S.TIMEOUT),
        ([S.PASSED, S.TIMEOUT, S.INFRASTRUCTURE], S.INFRASTRUCTURE),
    ],
)
def test_status_of_an_exercise_follows_from_its_checks(
    statuses: list[Status], expected: Status
) -> None:
    assert status_of([check(status) for status in statuses]) is expected


def test_points_are_the_sum_and_partial_credit_counts() -> None:
    result = ExerciseResult.from_checks(
        "3.1", [check(), check(S.FAILED, points=0.5), check(S.ERROR)]
    )
    assert (result.points, result.max_points) == (2.5, 6.0)


def test_a_result_survives_the_way_through_json() -> None:
    result = ExerciseResult.from_checks(
        "3.1", [check(), check(S.FAILED, message="no ü", hint="h", hidden=True)], notes=["a note"]
    )
    assert ExerciseResult.loads(result.dumps()) == result
    assert result.dumps().isascii()


def test_texts_are_cut_and_cleaned_when_a_result_is_made() -> None:
    made = check(S.FAILED, message="x" * 100_000, hint="half \ud800 pair")
    assert len(made.message) == MAX_TEXT
    assert made.message.endswith("(shortened)")
    made.hint.encode("utf-8")


@pytest.mark.parametrize(
    "changes",
    [
        {"points": 3.0},
        {"points": -1.0},
        {"points": float("nan")},
        {"max_points": float("inf")},
        {"points": 1.0},
        {"status": S.NOT_ATTEMPTED, "points": 2.0},
        {"status": S.INFRASTRUCTURE, "points": 2.0},
    ],
)
def test_impossible_points_are_refused(changes: dict[str, Any]) -> None:
    with pytest.raises(ResultError):
        check(**{"status": S.PASSED, **changes})


def good() -> dict[str, Any]:
    result = ExerciseResult.from_checks("3.1", [check(), check(S.FAILED)])
    value: dict[str, Any] = json.loads(result.dumps())
    return value


@pytest.mark.parametrize(
    "change",
    [
        lambda v: v.pop("status"),
        lambda v: v.update(extra=1),
        lambda v: v.update(status="passed"),
        lambda v: v.update(points=99.0),
        lambda v: v.update(points=True),
        lambda v: v.update(exercise_id=None),
        lambda v: v.update(checks={}),
        lambda v: v.update(notes=[1]),
        lambda v: v.update(notes=["x" * (MAX_TEXT + 1)]),
        lambda v: v["checks"][0].update(points="2"),
        lambda v: v["checks"][0].update(points=float("nan")),
        lambda v: v["checks"][0].update(status="great"),
        lambda v: v["checks"][0].update(status=["passed"]),
        lambda v: v["checks"][0].update(hidden=0),
        lambda v: v["checks"][0].update(message="x" * (MAX_TEXT + 1)),
        lambda v: v["checks"][0].pop("name"),
        lambda v: v["checks"].__setitem__(0, None),
    ],
)
def test_anything_else_than_a_result_is_refused(change: Any) -> None:
    value = good()
    change(value)
    with pytest.raises(ResultError):
        ExerciseResult.from_json(value)


_JSON = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
    max_leaves=20,
)


@given(_JSON)
@settings(deadline=None)
def test_any_json_is_a_result_or_a_result_error(value: object) -> None:
    with pytest.raises(ResultError):
        ExerciseResult.from_json(value)


@pytest.mark.parametrize("text", ["", "{", "[" * 100_000, b"\xff\xfe\x00", "null", "1e999"])
def test_any_text_is_a_result_or_a_result_error(text: str | bytes) -> None:
    with pytest.raises(ResultError):
        ExerciseResult.loads(text)


def test_a_verdict_without_checks_names_the_reason_in_one_check() -> None:
    result = ExerciseResult.without_checks("3.1", S.ERROR, message="x.ipynb is empty", max_points=5)
    assert (result.status, result.points, result.max_points) == (S.ERROR, 0.0, 5.0)
    assert [one.message for one in result.checks] == ["x.ipynb is empty"]
