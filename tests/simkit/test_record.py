"""Records: made by name or place, equal by value, never changed."""

from __future__ import annotations

import copy
import pickle

import pytest

from simkit.record import Record, replace


class Point(Record, kw_only=False):
    x: float
    y: float = 0.0


class Limit(Record):
    upper: float
    unit: str = "rad"

    @property
    def shown(self):
        return f"{self.upper} {self.unit}"


class SoftLimit(Limit):
    unit: str = "m"
    margin: float = 0.1


def test_fields_are_given_by_place_or_name_and_have_defaults():
    assert (Point(1).x, Point(1).y) == (1, 0.0)
    assert (Point(1, 2).y, Point(y=2, x=1).y, Point(1, y=2).y) == (2, 2, 2)
    assert Limit(upper=2).shown == "2 rad"


def test_records_are_equal_by_class_and_value():
    assert Point(1, 0.0) == Point(x=1)
    assert Point(1) != Point(2)
    assert Limit(upper=1) != SoftLimit(upper=1)
    assert Point(1) != (1, 0.0)
    assert len({Point(1, 2), Point(y=2, x=1), Point(2, 1)}) == 2
    with pytest.raises(TypeError, match="unhashable"):
        hash(Point([]))


def test_a_record_shows_its_fields_in_their_order():
    assert repr(Limit(unit="m", upper=1.5)) == "Limit(upper=1.5, unit='m')"
    assert repr(SoftLimit(upper=1)) == "SoftLimit(upper=1, unit='m', margin=0.1)"


@pytest.mark.parametrize(
    ("make", "complaint"),
    [
        (lambda: Limit(), "Limit lacks upper; its fields are upper, unit"),
        (lambda: Limit(upper=1, lower=0), "Limit has no field lower; its fields are upper, unit"),
        (lambda: Limit(uper=1), "Limit lacks upper; has no field uper"),
        (lambda: Limit(unit="m", lower=0), "Limit lacks upper; has no field lower"),
        (lambda: Limit(1), "Limit takes 0 fields by place, and 1 were given"),
        (lambda: Point(1, 2, 3), "Point takes 2 fields by place, and 3 were given"),
        (lambda: Point(1, x=2), "Point got x twice"),
        (lambda: Point(y=2), "Point lacks x"),
        (lambda: replace(Point(1), z=1), "Point has no field z"),
    ],
)
def test_wrong_fields_are_refused(make, complaint):
    with pytest.raises(TypeError, match=complaint):
        make()


def test_a_record_never_changes():
    point = Point(1, 2)
    with pytest.raises(AttributeError, match="Point never changes: cannot set 'x'"):
        point.x = 3
    with pytest.raises(AttributeError, match="Point never changes: cannot delete 'x'"):
        del point.x
    assert replace(point, x=3) == Point(3, 2)
    assert point == Point(1, 2)


def test_a_record_can_be_matched_copied_and_pickled():
    match Point(1, 2):
        case Point(x, y):
            assert (x, y) == (1, 2)
    limit = SoftLimit(upper=1)
    assert copy.deepcopy(limit) == copy.copy(limit) == pickle.loads(pickle.dumps(limit)) == limit
