"""Quaternion arithmetic against matrices."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from simkit.tf.rotation import (
    compose,
    conjugate,
    inverse,
    multiply,
    roll_pitch_yaw,
    rotate,
    slerp,
    through_matrix,
)
from simkit.tf.transform import Transform

UNIT = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]


def rotations(count, seed=0):
    rng = random.Random(seed)
    for _ in range(count):
        values = [rng.gauss(0.0, 1.0) for _ in range(4)]
        norm = math.sqrt(sum(v * v for v in values))
        yield tuple(v / norm for v in values)


def test_rotate_is_the_matrix(tools):
    for q in rotations(50):
        matrix = tools.matrix((0, 0, 0), q)[:3, :3]
        for i, axis in enumerate(UNIT):
            assert rotate(q, axis) == pytest.approx(matrix[:, i], abs=1e-12)


def test_multiply_turns_by_the_second_first(tools):
    for p, q in zip(rotations(30, 1), rotations(30, 2), strict=True):
        v = (0.3, -1.2, 2.0)
        assert rotate(multiply(p, q), v) == pytest.approx(rotate(p, rotate(q, v)), abs=1e-12)


def test_a_rotation_that_is_too_long_scales_by_its_square():
    assert rotate((0.0, 0.0, 0.0, 0.995), (1.0, 0.0, 0.0))[0] == pytest.approx(0.990025)


def test_compose_with_the_inverse_is_the_identity():
    for q in rotations(20, 3):
        t = Transform((1.0, -2.0, 0.5), q, 7)
        back = compose(t, inverse(t))
        assert back.translation == pytest.approx((0, 0, 0), abs=1e-12)
        assert back.rotation == pytest.approx((0, 0, 0, 1), abs=1e-12)
        assert inverse(inverse(t)).translation == pytest.approx(t.translation, abs=1e-12)


def test_halfway_is_as_far_from_both_ends():
    def angle(p, q):
        return 2.0 * math.acos(min(1.0, abs(multiply(conjugate(p), q)[3])))

    for p, q in zip(rotations(100, 4), rotations(100, 5), strict=True):
        half = slerp(p, q, 0.5)
        assert angle(p, half) == pytest.approx(angle(half, q), abs=1e-5)
        assert angle(p, half) == pytest.approx(angle(p, q) / 2.0, abs=1e-5)


def test_slerp_takes_the_shorter_way_in_the_hemisphere_of_its_start():
    for p, q in zip(rotations(50, 6), rotations(50, 7), strict=True):
        minus_q = tuple(-c for c in q)
        for ratio in (0.0, 0.3, 1.0):
            assert slerp(p, q, ratio) == pytest.approx(slerp(p, minus_q, ratio), abs=1e-12)
        assert sum(a * b for a, b in zip(p, slerp(p, q, 1.0), strict=True)) >= 0.0


def test_slerp_of_opposite_signs_stays():
    assert slerp((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, -1.0), 0.5) == (0.0, 0.0, 0.0, 1.0)


def test_slerp_agrees_with_the_oracle(tools):
    for p, q in zip(rotations(50, 8), rotations(50, 9), strict=True):
        start, end = tools.matrix((0, 0, 0), p), tools.matrix((0, 0, 0), q)
        expected = tools.between(start, end, 0.37)
        assert np.allclose(tools.matrix((0, 0, 0), slerp(p, q, 0.37)), expected, atol=1e-7)


@pytest.mark.parametrize(
    ("q", "expected"),
    [
        ((0.0, 0.0, 0.0, -1.0), (0.0, 0.0, 0.0, 1.0)),
        ((0.0, 0.0, 0.0, 0.995), (0.0, 0.0, 0.0, 1.0)),
        ((-1.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        ((0.6, -0.8, 0.0, 0.0), (-0.6, 0.8, 0.0, 0.0)),
    ],
)
def test_through_matrix_fixes_length_and_sign(q, expected):
    assert through_matrix(q) == pytest.approx(expected)


@pytest.mark.parametrize("angles", [(0.1, 0.2, 0.3), (-3.0, 1.5, -2.0), (0.0, -1.2, 3.1)])
def test_roll_pitch_yaw_undoes_the_three_turns(angles):
    roll, pitch, yaw = angles
    q = multiply(
        (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)),
        multiply(
            (0.0, math.sin(pitch / 2), 0.0, math.cos(pitch / 2)),
            (math.sin(roll / 2), 0.0, 0.0, math.cos(roll / 2)),
        ),
    )
    assert roll_pitch_yaw(q) == pytest.approx(angles, abs=1e-12)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
def test_at_the_poles_yaw_is_zero(pitch):
    q = (0.0, math.copysign(math.sqrt(0.5), pitch), 0.0, math.sqrt(0.5))
    _, found, yaw = roll_pitch_yaw(q)
    assert found == pytest.approx(pitch, abs=1e-7)
    assert yaw == pytest.approx(0.0, abs=1e-7)
