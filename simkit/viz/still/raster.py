"""Draws surfaces and lines in space as a camera sees them, the nearest in front; needs no browser and no GPU."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from simkit.viz.draw.drawing import Point
from simkit.viz.stage import style
from simkit.viz.stage.camera import NEAR, Camera, focal_length
from simkit.viz.stage.parts import Color
from simkit.viz.still.surfaces import Surface

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


Pixels: TypeAlias = NDArray[np.uint8]


class Eye:
    """A camera with a light beside it, and a picture that grows.

    Args:
        camera: Where it is.
        size: Width and height of the picture [px].
        fineness: Pixels that are computed for one of the picture, in each direction.
        rows: First row of computed pixels, and the one behind the last: a band of the picture.

    Attributes:
        fineness: As above.
        solid: What is drawn so far and hides what is behind it.
        paint: Red, green, blue, each times the opacity, and the opacity; shape (height, width, 4).
    """

    def __init__(self, camera: Camera, size: Point, fineness: int, rows: tuple[int, int]) -> None:
        self._width, self._height = round(size[0] * fineness), rows[1] - rows[0]
        self._middle = (self._width / 2, round(size[1] * fineness) / 2 - rows[0])
        self.fineness = fineness
        self._focal = focal_length(size) * fineness
        self._camera = camera
        self._basis, self._target = np.array(camera.basis), np.array(camera.target)
        light = np.array(style.LIGHT) @ self._basis
        self._light = light / np.linalg.norm(light)
        self.solid = Layer(self._width, self._height)
        self.paint: Paint = np.zeros((self._height, self._width, 4), np.float32)

    def layer(self) -> Layer:
        """An empty picture of the same size."""
        return Layer(self._width, self._height)

    def surface(self, layer: Layer, surface: Surface, color: Color) -> None:
        """Draw the side of a surface that faces the camera."""
        points, nearness, shades = self._seen(surface)
        layer.draw(points, nearness, shades[:, :, None] * np.array(color))

    def lines(self, layer: Layer, segments: Array, *, width: float, color: Color) -> None:
        """Draw lines of a width on paper [px] in one go.

        Args:
            layer: Where to draw.
            segments: Start and end of each line [m]; shape (n, 2, 3).
            width: Width of the lines [px].
            color: Their colour.
        """
        seen = (segments - self._target) @ self._basis.T
        seen[:, :, 2] = self._camera.distance - seen[:, :, 2]
        seen = _before(seen, 1.0001 * NEAR * self._camera.distance)
        ends = self._on_paper(seen)
        along = ends[:, 1] - ends[:, 0]
        lengths = np.hypot(along[:, 0], along[:, 1])
        ys = ends[:, :, 1]
        drawn = (
            (lengths > 1e-9) & (ys.max(axis=1) > -width) & (ys.min(axis=1) < self._height + width)
        )
        seen, ends, along, lengths = seen[drawn], ends[drawn], along[drawn], lengths[drawn]
        aside = width / 2 / lengths[:, None] * np.stack([-along[:, 1], along[:, 0]], axis=1)
        (a, c), (b, d) = ((ends[:, end] + aside, ends[:, end] - aside) for end in (0, 1))
        points = np.stack([np.stack([a, b, c], axis=1), np.stack([b, d, c], axis=1)], axis=1)
        near_start, near_end = 1.0 / seen[:, 0, 2], 1.0 / seen[:, 1, 2]
        nearness = np.stack(
            [near_start, near_end, near_start, near_end, near_end, near_start], axis=1
        )
        count = 2 * len(seen)
        colors = np.broadcast_to(np.array(color), (count, 3, 3))
        layer.draw(points.reshape(count, 3, 2), nearness.reshape(count, 3), colors)

    def lay(self, layer: Layer, opacity: Array) -> None:
        """Lay a picture over what is painted; its opacity has the shape (height, width)."""
        _lay(self.paint, layer.colors, opacity)

    def lay_veil(self, surface: Surface, color: Color, alpha: float) -> None:
        """Lay a surface that light goes through over what is painted, where nothing is before it."""
        points, nearness, shades = self._seen(surface)
        if not len(points):
            return  # nothing of it faces here
        most = (self._width, self._height)
        left, top = np.clip(np.floor(points.min(axis=(0, 1))), 0, most).astype(int)
        right, bottom = np.clip(np.ceil(points.max(axis=(0, 1))), 0, most).astype(int)
        window = Layer(right - left, bottom - top)
        window.draw(points - (left, top), nearness, shades[:, :, None] * np.array(color))
        here = slice(top, bottom), slice(left, right)
        is_before = window.nearness > self.solid.nearness[here]
        _lay(self.paint[here], window.colors, np.where(is_before, alpha, 0.0))

    def pixels(self, fineness: int) -> Pixels:
        """The picture, of which each pixel is the mean of `fineness`² computed ones."""
        steps = range(fineness)
        parts = [self.paint[i::fineness, j::fineness] for i in steps for j in steps]
        mean = np.add.reduce(parts) / np.float32(fineness**2)
        opacity = mean[:, :, 3:]
        mean[:, :, :3] /= np.where(opacity > 0.0, opacity, 1.0)
        found: Pixels = np.round(255.0 * np.clip(mean, 0.0, 1.0)).astype(np.uint8)
        return found

    def _seen(self, surface: Surface) -> tuple[Array, Array, Array]:
        """Corners on paper, their nearness, and how bright they are, of triangles that face here."""
        seen = (surface.corners - self._target) @ self._basis.T
        seen[:, :, 2] = self._camera.distance - seen[:, :, 2]
        before = (seen[:, :, 2] > NEAR * self._camera.distance).all(axis=1)
        seen = seen[before]
        points = self._on_paper(seen)
        (x1, y1), (x2, y2) = ((points[:, i] - points[:, 0]).T for i in (1, 2))
        facing = x1 * y2 - x2 * y1 < 0.0  # counter-clockwise, on paper with y down
        ys = points[:, :, 1]
        facing &= (ys.max(axis=1) > 0.0) & (ys.min(axis=1) < self._height)
        lit = np.clip(surface.normals[before][facing] @ self._light, 0.0, 1.0)
        shades = style.AMBIENT + (1.0 - style.AMBIENT) * lit
        return points[facing], 1.0 / seen[facing][:, :, 2], shades

    def _on_paper(self, seen: Array) -> Array:
        scale = self._focal / seen[..., 2]
        x, y = self._middle[0] + seen[..., 0] * scale, self._middle[1] - seen[..., 1] * scale
        return np.stack([x, y], axis=-1)


def _before(seen: Array, near: float) -> Array:
    """Of lines as seen, shape (n, 2, 3), the parts that are not nearer than a depth [m]."""
    seen = seen[(seen[:, :, 2] > near).any(axis=1)]
    for end in (0, 1):
        behind = seen[:, end, 2] < near
        here, there = seen[behind, end], seen[behind, 1 - end]
        ratio = (near - here[:, 2]) / (there[:, 2] - here[:, 2])
        seen[behind, end] = here + ratio[:, None] * (there - here)
    return seen


def _lay(paint: Paint, colors: Paint, opacity: Array) -> None:
    touched = opacity > 0.0
    over = opacity[touched][:, None].astype(np.float32)
    coat = np.concatenate([colors[touched] * over, over], axis=1)
    paint[touched] = paint[touched] * (1.0 - over) + coat
