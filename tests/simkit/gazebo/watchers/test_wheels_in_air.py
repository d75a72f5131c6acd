"""Wheels that touch nothing are told, when they are to drive."""

from __future__ import annotations

from tests.simkit.plugins.samples import CAR

ON_CASTERS = CAR.replace('xyz="0.2 0 -0.05"', 'xyz="0.2 0 -0.08"').replace(
    'xyz="-0.2 0 -0.05"', 'xyz="-0.2 0 -0.08"'
)


def test_a_car_that_stands_on_its_casters(watched):
    watched.car(robot=ON_CASTERS, z=0.13)
    watched.run(0.5)
    watched.tell(0.4)
    watched.run(3)
    (text,) = watched.found("GZ-W04")
    assert "'left', 'right' touch nothing, 0.03 m above the floor: it stands on 'base'" in text


def test_it_says_nothing_while_nothing_is_told(watched):
    watched.car(robot=ON_CASTERS, z=0.13)
    watched.run(1.5)
    assert watched.found() == []


def test_a_car_on_its_wheels(watched):
    watched.car()
    watched.run(0.2)
    watched.tell(0.4)
    watched.run(2)
    assert watched.found() == []


def test_a_car_that_falls_is_not_on_its_casters(watched):
    watched.car(z=3)
    watched.tell(0.4)
    watched.run(1.5)
    assert watched.found() == []
