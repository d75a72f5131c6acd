"""Small matrices, 3 by 3, as tuples of rows: rotations and inertia tensors without numpy."""

from __future__ import annotations

import math

from simkit.geometry import IDENTITY_MATRIX, Matrix, Vector

_SWEEPS = 30
"Jacobi needs about five; numbers that are not finite never get there."


def diagonal(entries: Vector) -> Matrix:
    """The matrix with these entries on its diagonal."""
    a, b, c = entries
    return ((a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c))


def transpose(matrix: Matrix) -> Matrix:
    """Rows for columns: of a rotation its inverse."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return ((a, d, g), (b, e, h), (c, f, i))


def apply(matrix: Matrix, vector: Vector) -> Vector:
    """The product of a matrix and a column."""
    x, y, z = vector
    (a, b, c), (d, e, f), (g, h, i) = matrix
    return (a * x + b * y + c * z, d * x + e * y + f * z, g * x + h * y + i * z)


def product(left: Matrix, right: Matrix) -> Matrix:
    """The product of two matrices: for rotations R_ac = R_ab R_bc."""
    columns = transpose(right)
    return transpose((apply(left, columns[0]), apply(left, columns[1]), apply(left, columns[2])))


def added(left: Matrix, right: Matrix) -> Matrix:
    """The sum of two matrices."""
    (a, b, c), (d, e, f), (g, h, i) = left
    (j, k, m), (n, o, p), (q, r, s) = right
    return ((a + j, b + k, c + m), (d + n, e + o, f + p), (g + q, h + r, i + s))


def eigenvalues(matrix: Matrix) -> Vector:
    """The three eigenvalues of a symmetric matrix, the smallest first.

    Source:
        Jacobi's rotations, which also find the small ones of a matrix of uneven size.
    """
    turned = matrix
    for _ in range(_SWEEPS):
        if turned[0][1] == turned[0][2] == turned[1][2] == 0.0:
            break
        for row, column in ((0, 1), (0, 2), (1, 2)):
            turned = _without(turned, row, column)
    low, middle, high = sorted((turned[0][0], turned[1][1], turned[2][2]))
    return (low, middle, high)


def _without(matrix: Matrix, row: int, column: int) -> Matrix:
    """The same matrix in axes that are turned so that one entry beside the diagonal is gone."""
    entry = matrix[row][column]
    if entry == 0.0:
        return matrix
    angle = 0.5 * math.atan2(2.0 * entry, matrix[column][column] - matrix[row][row])
    cos, sin = math.cos(angle), math.sin(angle)
    turn = [list(line) for line in IDENTITY_MATRIX]
    turn[row][row] = turn[column][column] = cos
    turn[row][column], turn[column][row] = sin, -sin
    rotation = tuple(tuple(line) for line in turn)
    done = product(transpose(rotation), product(matrix, rotation))  # type: ignore[arg-type]
    cleared = [list(line) for line in done]
    cleared[row][column] = cleared[column][row] = 0.0
    return tuple(tuple(line) for line in cleared)  # type: ignore[return-value]
