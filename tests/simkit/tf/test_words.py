"""A pose in words."""

from __future__ import annotations

import math

from simkit.tf import Transform, in_words


def test_where_and_how_turned(yaw):
    pose = Transform((1.2, 0.3, 0.0), yaw(math.pi / 6))
    assert in_words("turtle2", "turtle1", pose) == (
        '"turtle1" seen from "turtle2": 1.200 m ahead, 0.300 m left; turned 30.0° to the left'
    )


def test_all_directions():
    q = (-math.sin(0.1), 0.0, 0.0, math.cos(0.1))
    assert in_words("a", "b", Transform((-1.0, -2.0, -3.0), q)) == (
        '"b" seen from "a": 1.000 m behind, 2.000 m right, 3.000 m down; rolled 11.5° to the left'
    )


def test_nothing():
    assert in_words("a", "b", Transform((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))) == (
        '"b" seen from "a": at the same place; not turned'
    )
