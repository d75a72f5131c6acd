"""Small matrices against numpy."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.geometry import IDENTITY_MATRIX, Matrix, matrix_from_rpy
from simkit.urdf.matrix import (
    added,
    apply,
    diagonal,
    eigenvalues,
    product,
    transpose,
)

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
    tensor = product(turn, product(diagonal(wanted), transpose(turn)))
    assert eigenvalues(tensor) == pytest.approx(wanted, rel=1e-6)


def test_a_diagonal_matrix_has_its_entries_as_eigenvalues_exactly():
    assert eigenvalues(diagonal((3.0, 1.0, 2.0))) == (1.0, 2.0, 3.0)
    assert eigenvalues(IDENTITY_MATRIX) == (1.0, 1.0, 1.0)


def test_numbers_that_are_none_do_not_hang_it():
    found = eigenvalues(((math.inf, 1.0, 2.0), (1.0, math.nan, 3.0), (2.0, 3.0, 4.0)))
    assert any(math.isnan(value) for value in found)
