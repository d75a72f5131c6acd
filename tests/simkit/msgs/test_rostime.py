"""Time and Duration behave as genpy's."""

from __future__ import annotations

import copy
import operator
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.msgs import Duration, Time, TVal

SEC = 1_000_000_000
times = st.integers(0, 2**32 * SEC - 1).map(Time.from_nsec)
durations = st.integers(-(2**31) * SEC, 2**31 * SEC - 1).map(Duration.from_nsec)


class NodeTime(Time):
    __slots__ = ()


@pytest.mark.parametrize(
    ("secs", "nsecs", "canonical"),
    [
        (0, 0, (0, 0)),
        (1, SEC, (2, 0)),
        (1, SEC + 1, (2, 1)),
        (1, -999_999_999, (0, 1)),
        (-1, -SEC, (-2, 0)),
        (-1, 1, (-1, 1)),
        (0, -1, (-1, 999_999_999)),
        (0.5, 0, (0, 500_000_000)),
        (-0.5, 0, (-1, 500_000_000)),
        (np.int32(3), np.int64(4), (3, 4)),
    ],
)
def test_constructor_is_canonical(secs, nsecs, canonical):
    value = Duration(secs, nsecs)
    assert (value.secs, value.nsecs) == canonical
    assert type(value.secs) is int
    assert type(value.nsecs) is int


def test_float_seconds_exclude_nanoseconds():
    with pytest.raises(ValueError, match="if secs is a float, nsecs cannot be set"):
        Duration(0.5, 5)


def test_time_is_never_negative():
    with pytest.raises(TypeError, match=r"^time values must be positive$"):
        Time(-1)
    with pytest.raises(TypeError, match=r"^time values must be positive$"):
        Time(3) - Duration(5.0)


def test_text_and_repr():
    assert str(Time(1, 5)) == "1000000005"
    assert str(Duration(-1, 0)) == "-1000000000"
    assert repr(Time(12345)) == "genpy.Time[12345000000000]"
    assert repr(Duration(0, 7)) == "genpy.Duration[7]"
    assert repr(TVal(1)) == "genpy.TVal[1000000000]"


def test_conversions():
    assert Time.from_sec(1.5) == Time(1, 500_000_000) == Time.from_seconds(1.5)
    assert Time(1, 500_000_000).to_sec() == Time(1.5).to_time() == 1.5
    assert Time(2, 3).to_nsec() == 2 * SEC + 3
    assert not Time()
    assert Time().is_zero()
    assert Duration(0, 1)


def test_set_and_canon():
    value = Duration()
    value.set(0, 3 * SEC)
    assert (value.secs, value.nsecs) == (0, 3 * SEC)
    value.canon()
    assert (value.secs, value.nsecs) == (3, 0)


def test_scaling():
    assert Duration(2) * 2 == 2 * Duration(2) == Duration(4)
    assert Duration(4) * 2.5 == Duration(10)
    assert Duration(9) // 2 == Duration(4)
    assert Duration(8) // 2.0 == Duration(8) / 2 == Duration(4)
    assert Duration(5) / Duration(2) == 2.5
    assert Duration(5) // Duration(2) == 2
    assert Duration(5) % Duration(2) == Duration(1)
    assert divmod(Duration(5), Duration(2)) == (2, Duration(1))
    assert abs(Duration(0, -1)) == -Duration(0, -1) == Duration(0, 1)


@pytest.mark.parametrize(
    ("operation", "left", "right"),
    [
        (operator.add, Time(1), Time(1)),
        (operator.add, Time(1), 1),
        (operator.add, Duration(1), 1.0),
        (operator.sub, Time(1), 1),
        (operator.sub, Duration(1), Time(1)),
        (operator.sub, Duration(1), 1),
        (operator.mul, Duration(1), "2"),
        (operator.truediv, Duration(1), "2"),
        (operator.floordiv, Duration(1), None),
        (operator.mod, Duration(1), 2),
        (operator.lt, Time(1), Duration(2)),
        (operator.ge, Duration(1), 0),
        (operator.gt, Time(1), 0.5),
        (operator.le, TVal(1), 1),
    ],
)
def test_operations_that_do_not_exist(operation, left, right):
    with pytest.raises(TypeError):
        operation(left, right)
    assert left != 1


def test_a_subclass_mixes_with_its_base():
    later = NodeTime(1) + Duration(1)
    assert type(later) is Time
    assert type(NodeTime.from_sec(2.0)) is NodeTime
    assert later == NodeTime(2)
    assert NodeTime(1) < later
    assert hash(later) == hash(NodeTime(2))
    assert later != Duration(2)


def test_copies_are_independent():
    first = Time(1, 2)
    for other in (copy.deepcopy(first), pickle.loads(pickle.dumps(first))):
        assert other == first
        other.secs = 5
        assert first.secs == 1


@given(times, durations)
def test_adding_and_taking_away(time, duration):
    if time.to_nsec() + duration.to_nsec() < 0:
        with pytest.raises(TypeError):
            time + duration
        return
    later = time + duration
    assert later == duration + time
    assert later - duration == time
    assert later - time == duration
    assert later.to_nsec() == time.to_nsec() + duration.to_nsec()
    assert 0 <= later.nsecs < SEC


@given(durations, durations)
def test_durations_are_ordered_as_their_nanoseconds(first, second):
    a, b = first.to_nsec(), second.to_nsec()
    assert (first < second, first <= second, first == second) == (a < b, a <= b, a == b)
    assert (first > second, first >= second, first != second) == (a > b, a >= b, a != b)
    assert (first + second).to_nsec() == a + b
    assert (first - second).to_nsec() == a - b
    assert (-first).to_nsec() == -a
