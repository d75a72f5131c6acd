"""Matrices, Euler angles and quaternions: known values, and laws on random ones."""

from __future__ import annotations

import math
from itertools import pairwise, product

import numpy as np
import pytest
import transformations

from simkit.errors import UnknownNameError
from simkit.tf import transformations as tft

ALL_AXES = [
    frame + letters
    for frame in "sr"
    for letters in map("".join, product("xyz", repeat=3))
    if letters[0] != letters[1] != letters[2]
]
RNG = np.random.default_rng(0)
ANGLES = [tuple(RNG.uniform(-3.1, 3.1, 3)) for _ in range(20)]


def turn(axis, angle):
    """Rotation about one axis, written out."""
    c, s = math.cos(angle), math.sin(angle)
    matrices = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return np.array(matrices[axis])


def expected_matrix(axes, angles):
    first, second, third = (
        turn(letter, angle) for letter, angle in zip(axes[1:], angles, strict=True)
    )
    return third @ second @ first if axes[0] == "s" else first @ second @ third


# -- observed values of tf


@pytest.mark.parametrize(
    ("angles", "axes", "expected"),
    [
        ((0, 0, 1), "sxyz", (0, 0, 0.47942554, 0.87758256)),
        ((0.1, 0.2, 0.3), "sxyz", (0.0342708, 0.10602051, 0.14357218, 0.98334744)),
        ((0.1, 0.2, 0.3), "rxyz", (0.06407135, 0.09115755, 0.1534393, 0.98185617)),
    ],
)
def test_quaternion_from_euler(angles, axes, expected):
    q = tft.quaternion_from_euler(*angles, axes)
    assert isinstance(q, np.ndarray)
    assert q.shape == (4,)
    assert q == pytest.approx(expected, abs=1e-8)


def test_euler_from_quaternion_at_the_pole():
    angles = tft.euler_from_quaternion((0, 0.70710678, 0, 0.70710678))
    assert isinstance(angles, tuple)
    assert angles == pytest.approx((0.0, 1.5707963, 0.0), abs=1e-7)
    assert math.copysign(1.0, angles[0]) == -1.0


def test_quaternion_about_axis():
    q = tft.quaternion_about_axis(0.123, (1, 0, 0))
    assert q == pytest.approx((0.06146124, 0, 0, 0.99810947), abs=1e-8)
    assert tft.quaternion_about_axis(0.123, (7, 0, 0)) == pytest.approx(q)


def test_the_quaternion_of_zeros_turns_nothing():
    assert np.array_equal(tft.quaternion_matrix((0, 0, 0, 0)), np.identity(4))


# -- the 24 axis sequences


def test_there_are_24_sequences():
    assert len(ALL_AXES) == 24


@pytest.mark.parametrize("axes", ALL_AXES)
def test_euler_matrix_is_the_product_of_its_turns(axes):
    for angles in ANGLES:
        matrix = tft.euler_matrix(*angles, axes)
        assert np.allclose(matrix[:3, :3], expected_matrix(axes, angles), atol=1e-12)
        q = tft.quaternion_from_euler(*angles, axes)
        assert np.allclose(tft.quaternion_matrix(q), matrix, atol=1e-12)


@pytest.mark.parametrize("axes", ALL_AXES)
def test_angles_give_back_the_matrix(axes):
    for angles in ANGLES:
        matrix = tft.euler_matrix(*angles, axes)
        found = tft.euler_from_matrix(matrix, axes)
        assert np.allclose(tft.euler_matrix(*found, axes), matrix, atol=1e-12)
        found = tft.euler_from_quaternion(tft.quaternion_from_matrix(matrix), axes)
        assert np.allclose(tft.euler_matrix(*found, axes), matrix, atol=1e-12)


@pytest.mark.parametrize("axes", ALL_AXES)
def test_small_angles_come_back_themselves(axes):
    odd = "xyz".index(axes[2]) != ("xyz".index(axes[1]) + 1) % 3
    # Of the odd sequences that return to their first axis, the middle angle is negative.
    middle = -0.4 if odd and axes[1] == axes[3] else 0.4
    angles = (0.3, middle, 0.5)
    found = tft.euler_from_matrix(tft.euler_matrix(*angles, axes), axes)
    assert found == pytest.approx(angles, abs=1e-12)


@pytest.mark.parametrize("axes", ALL_AXES)
def test_where_two_axes_fall_together(axes):
    middle = 0.0 if axes[1] == axes[3] else math.pi / 2
    for sign in (1.0, -1.0):
        matrix = tft.euler_matrix(0.3, sign * middle, 0.5, axes)
        found = tft.euler_from_matrix(matrix, axes)
        assert np.allclose(tft.euler_matrix(*found, axes), matrix, atol=1e-7)


def test_axes_may_be_written_in_capitals_or_as_numbers():
    angles = (0.1, 0.2, 0.3)
    assert tft.euler_matrix(*angles, "SXYZ") == pytest.approx(tft.euler_matrix(*angles))
    assert tft.euler_matrix(*angles, (0, 0, 0, 0)) == pytest.approx(tft.euler_matrix(*angles))
    expected = tft.euler_matrix(*angles, "rxyz")
    assert tft.euler_matrix(*angles, (2, 1, 0, 1)) == pytest.approx(expected)


@pytest.mark.parametrize("axes", ["xyz", "sxxy", "qxyz", (9, 9, 9, 9)])
def test_unknown_axes(axes):
    with pytest.raises(UnknownNameError, match="no axis sequence") as caught:
        tft.euler_matrix(0, 0, 0, axes)
    assert isinstance(caught.value, KeyError)


# -- quaternions


@pytest.fixture
def quaternions():
    np.random.seed(1)
    return [tft.random_quaternion() for _ in range(40)]


def test_multiply_is_the_product_of_matrices(quaternions):
    for p, q in pairwise(quaternions):
        found = tft.quaternion_matrix(tft.quaternion_multiply(p, q))
        assert np.allclose(found, tft.quaternion_matrix(p) @ tft.quaternion_matrix(q))


def test_multiply_known_value():
    assert list(tft.quaternion_multiply([1, -2, 3, 4], [-5, 6, 7, 8])) == [-44, -14, 48, 28]


def test_inverse(quaternions):
    for q in quaternions:
        product_ = tft.quaternion_multiply(3 * q, tft.quaternion_inverse(3 * q))
        assert product_ == pytest.approx((0, 0, 0, 1))
        assert tft.quaternion_conjugate(q) == pytest.approx(tft.quaternion_inverse(q))


def test_matrix_there_and_back_with_the_sign_of_tf(quaternions):
    for q in quaternions:
        found = tft.quaternion_from_matrix(tft.quaternion_matrix(2.5 * q))
        assert found == pytest.approx(q) or found == pytest.approx(-q)
        leading = found[3] if abs(found[3]) > 0.5 else max(found[:3], key=abs)
        assert leading > 0.0


def test_the_package_begins_with_w(quaternions):
    for q in quaternions:
        assert tft.quaternion_matrix(q) == pytest.approx(
            transformations.quaternion_matrix(q[[3, 0, 1, 2]])
        )


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (-1, 2, -3)])
def test_half_turns_have_a_quaternion(axis):
    matrix = tft.rotation_matrix(math.pi, axis)
    assert np.allclose(tft.quaternion_matrix(tft.quaternion_from_matrix(matrix)), matrix)


def test_slerp(quaternions):
    for p, q in pairwise(quaternions):
        assert tft.quaternion_slerp(p, q, 0.0) == pytest.approx(p)
        assert tft.quaternion_slerp(p, q, 1.0) == pytest.approx(q)
        half = tft.quaternion_slerp(p, q, 0.5)
        assert np.linalg.norm(half) == pytest.approx(1.0)
        assert abs(half @ p) == pytest.approx(abs(half @ q))
        longer = tft.quaternion_slerp(p, -q, 0.5, shortestpath=False)
        assert abs(longer @ half) == pytest.approx(0.0, abs=1e-9) or longer == pytest.approx(half)


def test_slerp_of_equal_rotations_and_with_spin():
    q = tft.quaternion_about_axis(0.4, (0, 0, 1))
    assert tft.quaternion_slerp(q, q, 0.3) == pytest.approx(q)
    assert tft.quaternion_slerp(q, -q, 0.3) == pytest.approx(q)
    p = tft.quaternion_about_axis(1.4, (0, 0, 1))
    spun = tft.quaternion_slerp(q, p, 0.5, spin=1)
    angle = 0.5 + math.pi
    expected = (math.sin(angle / 2) * (q + p)) / math.sin(angle)
    assert spun == pytest.approx(expected)


# -- matrices


def test_concatenate_and_inverse():
    a, b = tft.translation_matrix((1, 2, 3)), tft.rotation_matrix(0.7, (1, 1, 0))
    assert tft.concatenate_matrices(a, b) == pytest.approx(a @ b)
    assert tft.concatenate_matrices() == pytest.approx(np.identity(4))
    assert tft.inverse_matrix(a @ b) @ a @ b == pytest.approx(np.identity(4))
    assert tft.translation_from_matrix(a @ b) == pytest.approx((1, 2, 3))


POINT, NORMAL = (0.1, 0.2, 0.3), (0.2, -0.1, 1.0)
MADE_AND_TAKEN_APART = [
    (tft.rotation_matrix, tft.rotation_from_matrix, (0.7, (0, 0, 2), (1, 0, 0))),
    (tft.rotation_matrix, tft.rotation_from_matrix, (3.0, (1, -2, 0.5), POINT)),
    (tft.reflection_matrix, tft.reflection_from_matrix, ((1, 2, 3), (0, 0, 2))),
    (tft.scale_matrix, tft.scale_from_matrix, (-1.234, (1, 2, 3))),
    (tft.scale_matrix, tft.scale_from_matrix, (2.0, (1, 2, 3), (3, 0, 0))),
    (tft.shear_matrix, tft.shear_from_matrix, (0.4, (1, 0, 0), (0.1, 0.2, 0.3), (0, 0.6, 0.8))),
    (tft.projection_matrix, tft.projection_from_matrix, (POINT, NORMAL)),
    (tft.projection_matrix, tft.projection_from_matrix, (POINT, NORMAL, (1.0, 0.5, 2.0))),
    (tft.projection_matrix, tft.projection_from_matrix, (POINT, NORMAL, None, (1.0, 2.0, 9.0))),
    (
        tft.compose_matrix,
        tft.decompose_matrix,
        ((1.5, -2.0, 0.5), (0.1, -0.2, 0.3), (0.3, -0.4, 1.0), (1, 2, 3), (0.01, -0.02, 0.03, 1)),
    ),
]


@pytest.mark.parametrize(("make", "take_apart", "arguments"), MADE_AND_TAKEN_APART)
def test_a_matrix_is_made_again_of_its_parts(make, take_apart, arguments):
    matrix = make(*arguments)
    assert tft.is_same_transform(make(*take_apart(matrix)), matrix)


def test_arguments_that_the_package_wants_by_keyword_may_stand_in_their_place():
    pseudo = tft.projection_matrix(POINT, NORMAL, None, (1.0, 2.0, 9.0), True)
    parts = tft.projection_from_matrix(pseudo, True)
    assert parts[-1] is True
    assert tft.is_same_transform(tft.projection_matrix(*parts), pseudo)
    box = (-1.0, 3.0, -2.0, 2.0, 1.0, 5.0)
    frustum = tft.clip_matrix(*box, True)
    assert np.array_equal(frustum, tft.clip_matrix(*box, perspective=True))
    assert not np.allclose(frustum, tft.clip_matrix(*box))


@pytest.mark.parametrize("scaling", [False, True])
@pytest.mark.parametrize("usesvd", [False, True])
def test_superimposition(scaling, usesvd):
    points = RNG.normal(size=(3, 20))
    motion = tft.concatenate_matrices(
        tft.translation_matrix((1, -2, 3)), tft.rotation_matrix(2.0, (1, 2, 3))
    )
    if scaling:
        motion = motion @ tft.scale_matrix(0.3)
    moved = motion @ np.vstack([points, np.ones(20)])
    assert np.allclose(tft.superimposition_matrix(points, moved, scaling, usesvd), motion)


# -- vectors and chance


def test_norms_and_unit_vectors():
    rows = np.array([[3.0, 4.0], [6.0, 8.0]])
    assert tft.vector_norm((3, 4)) == 5.0
    assert tft.vector_norm(rows, axis=1) == pytest.approx((5, 10))
    out = np.empty(2)
    assert tft.vector_norm(rows, 0, out) is None
    assert out == pytest.approx(np.sqrt((45, 80)))
    assert tft.unit_vector((3, 4)) == pytest.approx((0.6, 0.8))
    assert tft.unit_vector(rows, axis=1) == pytest.approx(np.array([[0.6, 0.8]] * 2))
    into = np.empty((2, 2))
    assert tft.unit_vector(rows, 1, into) is None
    assert into == pytest.approx(np.array([[0.6, 0.8]] * 2))


def test_random_rotations_are_rotations_and_repeatable():
    matrix = tft.random_rotation_matrix((0.1, 0.7, 0.3))
    assert matrix[:3, :3] @ matrix[:3, :3].T == pytest.approx(np.identity(3))
    assert np.linalg.norm(tft.random_quaternion((0.5, 0.2, 0.9))) == pytest.approx(1.0)
    np.random.seed(5)
    first = tft.random_quaternion()
    np.random.seed(5)
    assert tft.random_quaternion() == pytest.approx(first)
    assert tft.random_vector(7).shape == (7,)


def test_every_name_is_there():
    for name in tft.__all__:
        assert callable(getattr(tft, name))


# -- the trackball


def test_a_drag_from_the_middle_to_the_rim_turns_twice_the_angle_about_the_axis_between():
    ball = tft.Arcball()
    ball.place([200, 200], 100)
    ball.down([200, 200])
    ball.drag([250, 200])  # 30 degrees on the sphere, to the right
    expected = tft.rotation_matrix(math.radians(60), (0, 1, 0))
    np.testing.assert_allclose(ball.matrix(), expected, atol=1e-12)


@pytest.mark.parametrize("make", [tft.quaternion_from_euler, tft.euler_matrix])
def test_a_trackball_begins_as_it_is_told_and_a_drag_back_undoes(make):
    ball = tft.Arcball(make(0.1, 0.2, 0.3))
    before = ball.matrix()
    np.testing.assert_allclose(before, tft.euler_matrix(0.1, 0.2, 0.3), atol=1e-12)
    ball.place([0, 0], 100)
    ball.down([10, 20])
    ball.drag([60, -20])
    assert not np.allclose(ball.matrix(), before)
    ball.drag([10, 20])
    np.testing.assert_allclose(ball.matrix(), before, atol=1e-12)


def test_a_constrained_drag_keeps_the_axis():
    ball = tft.Arcball()
    ball.place([0, 0], 100)
    ball.setaxes([0, 0, 1])
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([80, 10])
    ball.drag([30, 70])
    np.testing.assert_allclose(ball.matrix()[:3, 2], [0, 0, 1], atol=1e-12)


def test_a_trackball_begins_with_a_quaternion_or_a_matrix():
    with pytest.raises(ValueError, match="quaternion"):
        tft.Arcball([1, 2, 3])
