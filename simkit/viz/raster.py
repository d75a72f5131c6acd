"""Triangles as pixels, the nearest one in front: a small renderer that needs no browser and no GPU."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Paint: TypeAlias = NDArray[np.float32]
Numbers: TypeAlias = NDArray[np.int64]

_CHUNK = 1_000_000
"So many pixels are looked at in one go."


class Layer:
    """A picture, and how near each of its pixels is.

    Args:
        width: Width [px].
        height: Height [px].

    Attributes:
        nearness: 1 / depth of what each pixel shows [1/m], 0 where nothing is; shape (height, width).
        colors: Its red, green, blue; shape (height, width, 3).
    """

    def __init__(self, width: int, height: int) -> None:
        self.width, self.height = width, height
        self.nearness: Array = np.zeros((height, width))
        self.colors: Paint = np.zeros((height, width, 3), np.float32)

    @property
    def filled(self) -> NDArray[np.bool_]:
        """Which pixels show something."""
        return self.nearness > 0.0

    def draw(self, points: Array, nearness: Array, colors: Array) -> None:
        """Draw triangles; of two that lie over each other the nearer one is seen.

        Args:
            points: Corners [px], x to the right, y down; shape (n, 3, 2).
            nearness: 1 / depth of each corner [1/m]; shape (n, 3).
            colors: Red, green, blue of each corner; shape (n, 3, 3).
        """
        if not len(points):
            return
        # All that is drawn is linear over a triangle: value = gradient . (x, y, 1). Depth is not, 1 / depth is.
        values = np.concatenate([nearness[:, :, None], colors], axis=2)
        slopes = _gradients(points, values)
        triangles, rows, starts, ends = _spans(points, self.width, self.height)
        lengths = ends - starts
        cuts = np.flatnonzero(np.diff(np.cumsum(lengths) // _CHUNK)) + 1
        for part in np.split(np.arange(len(lengths)), cuts):
            self._fill(slopes, triangles[part], rows[part], starts[part], lengths[part])

    def _fill(
        self, slopes: Array, triangles: Numbers, rows: Numbers, starts: Numbers, lengths: Numbers
    ) -> None:
        triangle, row = np.repeat(triangles, lengths), np.repeat(rows, lengths)
        first = np.repeat(starts - (np.cumsum(lengths) - lengths), lengths)
        column = np.arange(len(triangle)) + first
        place = np.stack([column + 0.5, row + 0.5, np.ones(len(row))], axis=1)
        near = np.einsum("ij,ij->i", slopes[triangle, 0], place)
        pixel = row * self.width + column
        nearness, colors = self.nearness.reshape(-1), self.colors.reshape(-1, 3)
        seen = np.flatnonzero(near > nearness[pixel])
        # The last value that is written to a pixel stays: the nearest has to come last.
        seen = seen[np.argsort(near[seen], kind="stable")]
        nearness[pixel[seen]] = near[seen]
        colors[pixel[seen]] = np.einsum("ikj,ij->ik", slopes[triangle[seen], 1:], place[seen])


def _gradients(points: Array, values: Array) -> Array:
    """For each value of each triangle the three numbers that give it from (x, y, 1)."""
    matrix = np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=2)
    thin = np.abs(np.linalg.det(matrix)) < 1e-9
    matrix[thin] = np.eye(3)  # seen from the side: no pixel of it is drawn
    return np.swapaxes(np.linalg.solve(matrix, values), 1, 2)


def _spans(points: Array, width: int, height: int) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """Triangle, row, first column and column behind the last of each row of pixels in a triangle."""
    top, bottom = (_pixels(f(points[:, :, 1], axis=1), height) for f in (np.min, np.max))
    counts = bottom - top
    triangles = np.repeat(np.arange(len(points)), counts)
    rows = np.arange(len(triangles)) + np.repeat(top - (np.cumsum(counts) - counts), counts)
    y = rows + 0.5
    left, right = np.full(len(rows), np.inf), np.full(len(rows), -np.inf)
    for start, end in ((0, 1), (1, 2), (2, 0)):
        (x0, y0), (x1, y1) = points[triangles, start].T, points[triangles, end].T
        crosses = (y0 <= y) != (y1 <= y)
        rise = np.where(crosses, y1 - y0, 1.0)
        x = x0 + (y - y0) / rise * (x1 - x0)
        left = np.where(crosses, np.minimum(left, x), left)
        right = np.where(crosses, np.maximum(right, x), right)
    starts, ends = _pixels(left, width), _pixels(right, width)
    kept = ends > starts
    return triangles[kept], rows[kept], starts[kept], ends[kept]


def _pixels(edges: Array, count: int) -> Numbers:
    """The first pixel whose middle is not before an edge, within the picture."""
    return np.clip(np.ceil(np.clip(edges, -1.0, count + 1.0) - 0.5), 0, count).astype(np.int64)
