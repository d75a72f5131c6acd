"""Rigid transforms: the laws of their group, and two libraries that compute the same."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
import transformations as peer
from hypothesis import given
from hypothesis import strategies as st
from pytransform3d import rotations as other_rotations
from pytransform3d import transformations as other_peer

from simkit.geometry import (
    IDENTITY_MATRIX,
    Transform,
    canonical,
    conjugate,
    matrix_from_quaternion,
    multiply,
    normalised,
    quaternion_from_axis,
    quaternion_from_matrix,
    quaternion_from_rpy,
    quaternion_from_z,
    roll_pitch_yaw,
    rotate,
    slerp,
)

THIRD = 1 / math.sqrt(3)
vectors = st.tuples(*[st.floats(-10.0, 10.0)] * 3)
angles = st.tuples(*[st.floats(-7.0, 7.0)] * 3)
quaternions = (
    st.tuples(*[st.floats(-1.0, 1.0)] * 4).filter(lambda q: math.hypot(*q) > 0.1).map(normalised)
)
transforms = st.builds(Transform, vectors, quaternions)


def near(values, abs=1e-9):  # noqa: A002 - the name that pytest gives it
    return pytest.approx(np.asarray(values), abs=abs)


def same(left: Transform, right: Transform) -> bool:
    """Whether two transforms are one, whatever the sign of their quaternions."""
    sign = math.copysign(1.0, sum(a * b for a, b in zip(*(t.rotation for t in (left, right)))))  # noqa: B905
    return left.translation == near(right.translation) and left.rotation == near(
        tuple(sign * c for c in right.rotation)
    )


def wxyz(q):
    return (q[3], *q[:3])


def is_half_a_turn(p, q):
    """Then either way round is as short."""
    return abs(sum(a * b for a, b in zip(p, q, strict=True))) < 1e-3


# The laws of the group.


@given(transforms, transforms, transforms)
def test_products_are_associative(a, b, c):
    assert same((a @ b) @ c, a @ (b @ c))


@given(transforms)
def test_the_identity_changes_nothing_and_the_inverse_undoes(t):
    assert same(t @ Transform(), t)
    assert same(Transform() @ t, t)
    assert same(t @ t.inverse(), Transform())
    assert same(t.inverse() @ t, Transform())


@given(transforms, transforms, vectors)
def test_a_product_applies_the_inner_transform_first(a, b, point):
    assert (a @ b).apply(point) == near(a.apply(b.apply(point)))
    assert a.inverse().apply(a.apply(point)) == near(point)


@given(transforms, vectors)
def test_vectors_turn_and_points_move_too(t, vector):
    x, y, z = t.translation
    assert t.apply(vector) == near(
        tuple(a + b for a, b in zip((x, y, z), t.rotate(vector), strict=True))
    )
    assert math.hypot(*t.rotate(vector)) == near(math.hypot(*vector))
    assert t.rotate_back(t.rotate(vector)) == near(vector)


def test_a_quarter_turn_takes_x_to_y():
    t = Transform.from_rpy((1.0, 2.0, 3.0), (0.0, 0.0, math.pi / 2))
    assert t.apply((1.0, 0.0, 0.0)) == near((1.0, 3.0, 3.0))


# Two other libraries.


@given(transforms, transforms)
def test_products_and_inverses_are_those_of_pytransform3d(a, b):
    def matrix(t):
        return other_peer.transform_from_pq((*t.translation, *wxyz(t.rotation)))

    assert matrix(a @ b) == near(matrix(a) @ matrix(b))
    assert matrix(a.inverse()) == near(other_peer.invert_transform(matrix(a)))


@given(quaternions, quaternions)
def test_quaternions_are_those_of_transformations(p, q):
    assert wxyz(multiply(p, q)) == near(peer.quaternion_multiply(wxyz(p), wxyz(q)))
    assert wxyz(conjugate(q)) == near(peer.quaternion_conjugate(wxyz(q)))
    assert matrix_from_quaternion(q) == near(peer.quaternion_matrix(wxyz(q))[:3, :3])


@given(angles)
def test_angles_are_about_the_fixed_axes_x_then_y_then_z(rpy):
    expected = peer.euler_matrix(*rpy, axes="sxyz")[:3, :3]
    assert matrix_from_quaternion(quaternion_from_rpy(rpy)) == near(expected)
    assert Transform.from_rpy((0.0, 0.0, 0.0), rpy).matrix == near(expected)


@given(quaternions)
def test_a_matrix_and_angles_bring_the_rotation_back(q):
    matrix = matrix_from_quaternion(q)
    assert matrix_from_quaternion(quaternion_from_matrix(matrix)) == near(matrix)
    assert canonical(q) == near(canonical(quaternion_from_matrix(matrix)), 1e-6)
    assert matrix_from_quaternion(quaternion_from_rpy(roll_pitch_yaw(q))) == near(matrix, 1e-6)


@given(quaternions, quaternions, st.floats(0.0, 1.0))
def test_slerp_is_that_of_pytransform3d(p, q, ratio):
    if is_half_a_turn(p, q):
        return
    expected = other_rotations.quaternion_slerp(wxyz(p), wxyz(q), ratio, shortest_path=True)
    assert matrix_from_quaternion(slerp(p, q, ratio)) == near(
        other_rotations.matrix_from_quaternion(expected), 1e-6
    )


@given(angles, st.floats(-7.0, 7.0))
def test_turns_about_an_axis_are_those_of_transformations(axis, angle):
    length = math.hypot(*axis)
    if length < 1e-3:
        return
    q = quaternion_from_axis(tuple(c / length for c in axis), angle)
    assert wxyz(q) == near(peer.quaternion_about_axis(angle, axis))


# Particular rotations.


def test_the_identity_is_exact():
    assert Transform().matrix == IDENTITY_MATRIX
    assert Transform.from_rpy((1.0, 2.0, 3.0), (0.0, 0.0, 0.0)) == Transform((1.0, 2.0, 3.0))
    assert Transform.from_matrix((1.0, 2.0, 3.0), IDENTITY_MATRIX) == Transform((1.0, 2.0, 3.0))


def test_an_axis_of_zeros_turns_nothing():
    assert quaternion_from_axis((0.0, 0.0, 0.0), 2.0) == (0.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize(
    "direction",
    [(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -1, 0), (THIRD, -THIRD, THIRD), (0.0, 6e-9, -1.0)],
)
def test_z_is_turned_into_the_direction_by_a_unit_quaternion(direction):
    turn = quaternion_from_z(direction)
    assert math.hypot(*turn) == pytest.approx(1.0)
    assert rotate(turn, (0.0, 0.0, 1.0)) == pytest.approx(direction, abs=1e-7)


def test_a_quaternion_that_is_too_long_scales_by_its_square():
    assert rotate((0.0, 0.0, 0.0, 0.995), (1.0, 0.0, 0.0))[0] == pytest.approx(0.990025)
    assert Transform(rotation=(0.0, 0.0, 0.0, 0.995)).normalised() == Transform()


@given(quaternions, quaternions, st.floats(0.0, 1.0))
def test_slerp_takes_the_shorter_way_in_the_hemisphere_of_its_start(p, q, ratio):
    if is_half_a_turn(p, q):
        return
    minus_q = tuple(-c for c in q)
    assert slerp(p, q, ratio) == near(slerp(p, minus_q, ratio))
    assert sum(a * b for a, b in zip(p, slerp(p, q, 1.0), strict=True)) >= 0.0


def test_slerp_of_opposite_signs_stays():
    assert slerp((0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, -1.0), 0.5) == (0.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize(
    ("q", "expected"),
    [
        ((0.0, 0.0, 0.0, -1.0), (0.0, 0.0, 0.0, 1.0)),
        ((0.0, 0.0, 0.0, 0.995), (0.0, 0.0, 0.0, 1.0)),
        ((-1.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)),
        ((0.6, -0.8, 0.0, 0.0), (-0.6, 0.8, 0.0, 0.0)),
    ],
)
def test_a_canonical_quaternion_has_unit_length_and_the_sign_of_a_matrix(q, expected):
    assert canonical(q) == pytest.approx(expected)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
def test_at_the_poles_yaw_is_zero(pitch):
    q = (0.0, math.copysign(math.sqrt(0.5), pitch), 0.0, math.sqrt(0.5))
    _, found, yaw = roll_pitch_yaw(q)
    assert found == pytest.approx(pitch, abs=1e-7)
    assert yaw == pytest.approx(0.0, abs=1e-7)


def test_long_chains_do_not_drift_if_they_are_normalised():
    rng = random.Random(0)
    step = Transform(rotation=normalised((rng.random(), rng.random(), rng.random(), 1.0)))
    found = Transform()
    for _ in range(10_000):
        found = (found @ step).normalised()
    assert math.hypot(*found.rotation) == near(1.0, 1e-15)
