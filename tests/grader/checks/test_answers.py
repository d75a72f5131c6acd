from __future__ import annotations

import pytest

from grader.checks.answers import given_answer, words_of
from grader.errors import CheckFailed
from grader.submission import Submission


@pytest.fixture
def submission() -> Submission:
    return Submission(student="s", exercise_id="3.2", files={}, answers={"frame": "/world"})


def test_an_answer_that_was_given(submission: Submission) -> None:
    assert given_answer(submission, "frame") == "/world"


def test_an_answer_that_was_not(submission: Submission) -> None:
    with pytest.raises(CheckFailed, match="distance has no answer yet") as failure:
        given_answer(submission, "distance")
    assert "distance = ..." in failure.value.hint


@pytest.mark.parametrize(
    ("answer", "words"),
    [
        ("/world, /carrot1", ["world", "carrot1"]),
        (["world", "carrot1"], ["world", "carrot1"]),
        ("'turtle1'", ["turtle1"]),
        (3, []),
        (None, []),
        ("x " * 10_000, ["x"] * 500),
    ],
)
def test_words_of_an_answer(answer: object, words: list[str]) -> None:
    assert words_of(answer) == words
