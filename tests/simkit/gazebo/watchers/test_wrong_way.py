"""A robot that goes the other way than it is told."""

from __future__ import annotations

import pytest

SWAPPED = {"left": "right", "right": "left"}


@pytest.mark.parametrize(
    ("car", "command", "says"),
    [
        (SWAPPED, (0.0, 0.8), "told to turn at +0.80 rad/s, and turns at -0.8"),
        ({"axes": (-1, -1)}, (0.3, 0.0), "told to drive at +0.30 m/s, and drives at -0.30 m/s"),
        ({"axes": (-1, 1)}, (0.3, 0.0), "told to drive straight on at +0.30 m/s, and turns on the spot at +1.5"),
    ],
    ids=["swapped", "backward", "against each other"],
)  # fmt: skip
def test_the_wrong_way_is_told_once_with_both_numbers(watched, car, command, says):
    watched.sdf_car(**car)
    watched.run(0.2)
    watched.tell(*command)
    watched.run(3)
    (text,) = watched.found("GZ-W02")
    assert says in text
    assert watched.found() == [text]


def test_swapped_wheels_are_named(watched):
    watched.sdf_car(**SWAPPED)
    watched.tell(0.0, -0.8)
    watched.run(1)
    (text,) = watched.found("GZ-W02")
    assert "the left joint is 'right_joint' now, the right one 'left_joint'" in text


@pytest.mark.parametrize("command", [(0.3, 0.0), (-0.3, 0.0), (0.0, 0.8), (0.0, -0.8), (0.3, 0.5)])
def test_the_right_way_is_not(watched, command):
    watched.sdf_car()
    watched.tell(*command)
    watched.run(2)
    assert watched.found() == []


def test_what_check_urdf_has_warned_of_is_not_said_again(watched):
    watched.car(**SWAPPED)
    watched.tell(0.0, 0.8)
    watched.run(1)
    assert watched.found() == []
