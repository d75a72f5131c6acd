from __future__ import annotations

import math

import pytest

from simkit.tf.rotation import rotate
from simkit.viz.turns import turn_from_z

THIRD = 1 / math.sqrt(3)


@pytest.mark.parametrize(
    "direction",
    [(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -1, 0), (THIRD, -THIRD, THIRD), (0.0, 6e-9, -1.0)],
)
def test_z_is_turned_into_the_direction_by_a_unit_quaternion(direction):
    turn = turn_from_z(direction)
    assert math.hypot(*turn) == pytest.approx(1.0)
    assert rotate(turn, (0.0, 0.0, 1.0)) == pytest.approx(direction, abs=1e-7)
