"""Inertia: formulas against sums over many points, laws against numpy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.geometry import IDENTITY_MATRIX, Matrix, Transform, matrix_from_rpy
from simkit.urdf import Box, Cylinder, Pose, Sphere
from simkit.urdf.inertia import (
    Body,
    added,
    apply,
    body_of_shapes,
    diagonal_matrix,
    eigenvalues,
    gyration_radius,
    is_positive_definite,
    merged,
    placed_body,
    point_tensor,
    product,
    shape_tensor,
    transpose,
    triangle_ratio,
    turned,
)
from simkit.urdf.placed_shape import PlacedShape

SHAPES = (Box((0.5, 0.3, 0.07)), Cylinder(0.1, 0.4), Sphere(0.2))

_vectors = st.tuples(*[st.floats(-2.0, 2.0)] * 3)
_points = st.lists(st.tuples(st.floats(0.1, 5.0), _vectors), min_size=1, max_size=8)
_poses = st.builds(Pose, _vectors, _vectors)


def tensor_of_points(masses, points):
    """About the centre of mass, as the definition says."""
    masses, points = np.array(masses), np.array(points)
    away = points - (masses[:, None] * points).sum(0) / masses.sum()
    squares = (away**2).sum(1)
    return sum(m * (s * np.eye(3) - np.outer(p, p)) for m, s, p in zip(masses, squares, away))  # noqa: B905


def near(tensor, *, size=1e-9):
    return pytest.approx(np.array(tensor), abs=size)


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_formulas_are_those_of_many_small_masses(shape):
    one = PlacedShape(shape, Transform())
    axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    half = [one.support(axis)[number] for number, axis in enumerate(axes)]
    steps = (np.arange(20) + 0.5) / 10.0 - 1.0
    x_s, y_s, z_s = (size * steps for size in half)
    cells = [(x, y, z) for x in x_s for y in y_s for z in z_s]
    inside = [cell for cell in cells if one.depth(cell) >= 0.0]
    tensor = tensor_of_points([3.0 / len(inside)] * len(inside), inside)
    assert np.array(shape_tensor(shape, 3.0)) == pytest.approx(tensor, rel=0.02, abs=1e-9)


def test_formulas_in_numbers_of_the_book():
    assert shape_tensor(Box((0.5, 0.3, 0.07)), 5.0)[0][0] == pytest.approx(0.0395416667)
    assert shape_tensor(Cylinder(0.1, 0.04), 0.2)[2][2] == pytest.approx(0.001)
    assert shape_tensor(Cylinder(0.1, 0.04), 0.2)[0][0] == pytest.approx(0.000526666667)
    assert shape_tensor(Sphere(0.1), 0.5)[0][0] == pytest.approx(0.002)


@given(_points, _poses)
def test_merged_points_are_one_body_wherever_they_are_seen_from(points, pose):
    bodies = [Body(mass, point, diagonal_matrix((0.0, 0.0, 0.0))) for mass, point in points]
    frame = pose.transform
    one, seen = merged(bodies), merged([placed_body(body, frame) for body in bodies])
    assert np.array(one.tensor) == near(tensor_of_points(*zip(*points, strict=True)), size=1e-7)
    assert np.array(seen.tensor) == near(placed_body(one, frame).tensor, size=1e-7)
    assert seen.centre == pytest.approx(frame.apply(one.centre), abs=1e-9)
    assert seen.mass == pytest.approx(one.mass)


@given(_points)
def test_no_body_of_points_breaks_the_triangle_inequality(points):
    bodies = [Body(mass, point, diagonal_matrix((0.0, 0.0, 0.0))) for mass, point in points]
    tensor = merged(bodies).tensor
    if np.linalg.eigvalsh(tensor)[1] > 1e-6:
        assert triangle_ratio(tensor) <= 1.0 + 1e-9


@given(_vectors, st.sampled_from(SHAPES))
def test_turning_a_tensor_changes_no_principal_moment(rpy, shape):
    tensor = shape_tensor(shape, 2.0)
    again = turned(tensor, matrix_from_rpy(rpy))
    assert np.linalg.eigvalsh(again) == pytest.approx(np.linalg.eigvalsh(tensor), abs=1e-12)
    assert is_positive_definite(again)
    assert gyration_radius(again, 2.0) == pytest.approx(gyration_radius(tensor, 2.0))


def test_the_parallel_axis_theorem():
    ring = point_tensor(2.0, (3.0, 0.0, 0.0))
    assert ring == ((0.0, 0.0, 0.0), (0.0, 18.0, 0.0), (0.0, 0.0, 18.0))


def test_lumping_the_car_of_the_book():
    chassis = Body(1.0, (0.0, 0.0, 0.2), diagonal_matrix((0.017, 0.033, 0.043)))
    ball = Body(0.5, (0.2, 0.0, 0.1), diagonal_matrix((0.002, 0.002, 0.002)))
    car = merged([chassis, ball])
    assert car.mass == 1.5
    assert car.centre == pytest.approx((0.0666667, 0.0, 0.1666667), abs=1e-6)
    (ixx, _, ixz), (_, iyy, _), (_, _, izz) = car.tensor
    assert (ixx, iyy, izz) == pytest.approx((0.0223333, 0.0516667, 0.0583333), abs=1e-6)
    assert ixz == pytest.approx(0.0066667, abs=1e-6)


def test_two_halves_of_a_box_are_the_box():
    half = Box((0.25, 0.3, 0.07))
    halves = [PlacedShape(half, Transform((x, 0.0, 0.0))) for x in (-0.125, 0.125)]
    whole = body_of_shapes(halves, 5.0)
    assert whole.centre == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)
    assert np.array(whole.tensor) == near(shape_tensor(Box((0.5, 0.3, 0.07)), 5.0), size=1e-9)


@pytest.mark.parametrize(
    ("moments", "definite", "ratio"),
    [
        ((1.0, 1.0, 2.0), True, 1.0),
        ((1.0, 1.0, 5.0), True, 2.5),
        ((1.0, -1.0, 1.0), False, math.inf),
        ((0.0, 1.0, 1.0), False, 1.0),
        ((0.0, 0.0, 0.0), False, math.inf),
    ],
)
def test_what_is_possible(moments, definite, ratio):
    assert is_positive_definite(diagonal_matrix(moments)) is definite
    assert triangle_ratio(diagonal_matrix(moments)) == ratio


def test_all_mass_on_a_ring_of_its_radius_of_gyration():
    assert gyration_radius(diagonal_matrix((0.045, 0.045, 0.09)), 1.0) == pytest.approx(0.3)


# small matrices, against numpy

_entries = st.floats(-1e3, 1e3)
_rows = st.tuples(_entries, _entries, _entries)
matrices = st.tuples(_rows, _rows, _rows)
angles = st.tuples(*[st.floats(-7.0, 7.0)] * 3)


def symmetric(matrix: Matrix) -> Matrix:
    return added(matrix, transpose(matrix))


@given(matrices, matrices, _rows)
def test_products_and_sums_are_those_of_numpy(left, right, vector):
    assert np.allclose(product(left, right), np.array(left) @ np.array(right), atol=1e-6)
    assert np.allclose(apply(left, vector), np.array(left) @ np.array(vector), atol=1e-6)
    assert np.allclose(added(left, right), np.array(left) + np.array(right))
    assert np.allclose(transpose(left), np.array(left).T)


@given(matrices)
def test_eigenvalues_are_those_of_numpy(matrix):
    matrix = symmetric(matrix)
    size = max(1e-300, np.abs(matrix).max())
    assert np.allclose(eigenvalues(matrix), np.linalg.eigvalsh(matrix), atol=1e-12 * size)


@pytest.mark.parametrize("scale", [1e-12, 1e-6, 1.0, 1e6])
def test_small_eigenvalues_beside_large_ones_keep_their_digits(scale):
    turn = matrix_from_rpy((0.3, -1.1, 2.0))
    wanted = (1e-6 * scale, 1e-3 * scale, scale)
    tensor = product(turn, product(diagonal_matrix(wanted), transpose(turn)))
    assert eigenvalues(tensor) == pytest.approx(wanted, rel=1e-6)


def test_a_diagonal_matrix_has_its_entries_as_eigenvalues_exactly():
    assert eigenvalues(diagonal_matrix((3.0, 1.0, 2.0))) == (1.0, 2.0, 3.0)
    assert eigenvalues(IDENTITY_MATRIX) == (1.0, 1.0, 1.0)


def test_numbers_that_are_none_do_not_hang_it():
    found = eigenvalues(((math.inf, 1.0, 2.0), (1.0, math.nan, 3.0), (2.0, 3.0, 4.0)))
    assert any(math.isnan(value) for value in found)
