"""Which angles look like degrees."""

import math

import pytest

from simkit.urdf.rules.angles import look_like_degrees


@pytest.mark.parametrize("angle", [7, 15, 45, -90, 120, 180, 360, 720, -135.5])
def test_degrees(angle):
    assert look_like_degrees(angle)


@pytest.mark.parametrize(
    "angle",
    [
        0,
        10,
        100,
        6.80678,
        9.25025,
        1.57,
        -3.14159,
        2 * math.pi,
        6.2832,
        12.566,
        -4 * math.pi,
        9.4248,
        1000,
        1e16,
    ],
)
def test_radians_turns_and_no_limit_at_all(angle):
    assert not look_like_degrees(angle)
