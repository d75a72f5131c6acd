import contextlib
import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.errors import ResultError
from grader.results import CheckResult, Status
from grader.run.events import Transcript

PLAN = [CheckResult(name=name, title=name, status=Status.SKIPPED, max_points=1) for name in "ab"]


def event(**values):
    return json.dumps(values).encode()


def planned():
    transcript = Transcript()
    transcript.add(event(event="plan", checks=[check.to_json() for check in PLAN]))
    return transcript


def passed(**changes):
    values = {"name": "a", "title": "a", "status": Status.PASSED, "points": 1, "max_points": 1}
    return CheckResult(**(values | changes)).to_json()


def test_a_run_is_told_step_by_step():
    transcript = planned()
    transcript.add(event(event="start", index=0))
    assert transcript.running == 0
    transcript.add(event(event="result", index=0, result=passed()))
    assert transcript.running is None
    assert transcript.results[0].points == 1
    transcript.add(event(event="end"))
    assert transcript.ended


@pytest.mark.parametrize(
    "line",
    [
        b"[1]",
        b"not json",
        b"[" * 100_000,
        event(event="pass"),
        event(event="start", index=2),
        event(event="start", index="0"),
        event(event="start", index=-1),
        event(event="plan", checks=[]),
        event(event="result", index=0),
        event(event="result", index=1, result=passed()),
        event(event="result", index=0, result=passed(title="b")),
        event(event="result", index=0, result=passed(max_points=5, points=5)),
        event(event="result", index=0, result=passed() | {"points": 3}),
    ],
)
def test_what_does_not_fit_is_refused(line):
    with pytest.raises(ResultError):
        planned().add(line)


def test_a_check_is_decided_once():
    transcript = planned()
    transcript.add(event(event="result", index=0, result=passed()))
    with pytest.raises(ResultError):
        transcript.add(event(event="result", index=0, result=passed()))


@given(st.binary() | st.recursive(st.none() | st.text(), st.lists).map(lambda x: event(event=x)))
def test_any_bytes_are_an_event_or_refused(line):
    transcript = planned()
    with contextlib.suppress(ResultError):
        transcript.add(line)
    assert not transcript.results
