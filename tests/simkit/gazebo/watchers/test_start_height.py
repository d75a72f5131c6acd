"""A model that begins in the floor, or above it, is told where it would stand."""

from __future__ import annotations

from simkit.graph import LogLevel
from tests.simkit.plugins.samples import PENDULUM, link


def test_in_the_floor(watched):
    watched.car(z=0.0)
    watched.run(0.5)
    (text,) = watched.found("GZ-W06")
    assert "car starts 0.1 m in the floor" in text
    assert "down to z = -0.1 m" in text
    assert text.endswith("Spawn it with -z 0.10")


def test_where_it_says_it_stands(watched):
    watched.car(z=0.1)
    watched.run(0.5)
    assert watched.found(level=LogLevel.INFO) == []


def test_above_the_floor_is_a_hint(watched):
    watched.car(z=1.0)
    watched.run(0.1)
    assert watched.found() == []
    (text,) = watched.found("GZ-W06", LogLevel.INFO)
    assert "starts 0.9 m above what is below it" in text
    assert "with -z 0.10 it starts on it" in text


def test_on_a_table_is_not_above_the_floor(watched):
    table = link("table", '<box size="2 2 0.5"/>') + "<gazebo><static>true</static></gazebo>"
    watched.spawn(table, name="table", pose=watched.at(z=0.25))
    watched.car(z=0.6)
    watched.run(0.1)
    assert watched.found(level=LogLevel.INFO) == []


def test_what_hangs_on_the_world_does_not_fall(watched):
    watched.spawn(PENDULUM, name="pendulum", pose=watched.at(z=2))
    assert watched.found(level=LogLevel.INFO) == []
