import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.checks import (
    CheckFailed,
    expect,
    expect_close,
    expect_close_angle,
    expect_equal,
)
from grader.checks.expect import explanation


def failure_of(function, *args, **kwargs):
    with pytest.raises(CheckFailed) as caught:
        function(*args, **kwargs)
    return caught.value


def test_what_holds_is_silent():
    expect(True, "no")
    expect_equal("world", "world", what="x")
    expect_equal(2, 2.0, what="x")
    expect_equal([1, 2], (1, 2), what="x")
    expect_close((1.0, 2.0), (1.0, 2.05), tolerance=0.1, what="x")
    expect_close(np.array([1.0, 2.0]), [1, 2], tolerance=0, what="x")
    expect_close([np.float64(1.0), 2], (1, 2), tolerance=0, what="x")
    expect_close_angle(math.pi - 0.01, -math.pi + 0.01, tolerance=0.03, what="x")


def test_a_failure_carries_message_and_hint():
    failure = failure_of(expect, False, "The turtle stands still.", hint="Publish a Twist.")
    assert failure.message == "The turtle stands still."
    assert failure.hint == "Publish a Twist."


def test_a_number_is_explained_with_unit_frame_and_tolerance():
    failure = failure_of(
        expect_close,
        (1.0, 2.0),
        (1.0, 2.5),
        tolerance=0.01,
        what="the position",
        unit="m",
        frame="world",
    )
    assert explanation(failure).splitlines() == [
        "The position is not right",
        "expected: (1, 2.5) m in frame world (within 0.01 m)",
        "got: (1, 2) m in frame world",
    ]


@pytest.mark.parametrize(
    ("actual", "said"),
    [
        (None, "nothing"),
        ("2.5", "'2.5' (a text)"),
        (True, "True (true or false)"),
        ([1, 2], "[1, 2] m"),
        ([[1], [2]], "[[1], [2]] (a list)"),
        (math.nan, "nan m"),
        (math.inf, "inf m"),
        ({"x": 1}, "{'x': 1} (a dictionary)"),
        (10**400, "a whole number of 1329 bits"),
    ],
)
def test_anything_but_the_number_is_a_failure_in_words(actual, said):
    failure = failure_of(expect_close, actual, 2.5, tolerance=0.1, what="the length", unit="m")
    assert failure.actual == said


class AlwaysEqual:
    def __eq__(self, other):
        return True

    __hash__ = None

    def __sub__(self, other):
        return 0.0

    __rsub__ = __sub__


def test_an_object_that_equals_everything_equals_nothing():
    failure_of(expect_equal, AlwaysEqual(), "world", what="x")
    failure_of(expect_close, AlwaysEqual(), 1.0, tolerance=1.0, what="x")


@pytest.mark.parametrize(("actual", "expected"), [(True, 1), (1, True), ("1", 1), (0, None)])
def test_equal_means_equal_in_kind(actual, expected):
    failure_of(expect_equal, actual, expected, what="x")


@given(st.floats(allow_nan=True), st.floats(-1e6, 1e6), st.floats(0, 1e3))
def test_close_is_a_distance(actual, expected, tolerance):
    try:
        expect_close(actual, expected, tolerance=tolerance, what="x")
        is_close = True
    except CheckFailed:
        is_close = False
    assert is_close == (abs(actual - expected) <= tolerance)


@given(st.floats(-10, 10), st.integers(-3, 3))
def test_full_turns_do_not_count(angle, turns):
    expect_close_angle(angle + turns * math.tau, angle, tolerance=1e-9, what="the heading")


def test_a_wrong_angle_is_told():
    failure = failure_of(expect_close_angle, 1.0, 0.5, tolerance=0.1, what="the heading")
    assert failure.expected == "0.5 rad (within 0.1 rad)"
    assert failure.actual == "1 rad"
    failure_of(expect_close_angle, math.inf, 0.5, tolerance=0.1, what="the heading")
    failure_of(expect_close_angle, [1, 2], 0.5, tolerance=0.1, what="the heading")
