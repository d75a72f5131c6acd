"""What a scene of frames needs to be seen: a grid, axes of the right size, and a camera."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.geometry import Vector
from simkit.viz.camera import Camera, fitted
from simkit.viz.tf_scene import FramePose, TfScene

_AZIMUTH, _ELEVATION = math.radians(-112.0), math.radians(32.0)
"From behind and the right: x leads to the right, y away, z up, as on paper."
AXIS_SHARE, AXIS_SHARE_OF_ROBOT = 0.09, 0.14
"Axes are signposts where frames are all there is; beside a robot they must not drown in it."
_CROWD = 12
"The axes of more frames than this are shorter, or nobody would see anything else."
_LEAST_EXTENT = 1e-3
"Frames that are no further apart than this [m] are in one place."


@dataclass(frozen=True, slots=True, kw_only=True)
class Stage:
    """A grid on the plane z = 0 of the fixed frame, and a camera."""

    axis_length: float
    """Length of each frame's axes [m]."""
    cell: float
    """Side of a cell of the grid [m]."""
    grid_x: tuple[int, int]
    """First and last line of the grid in x [cells]."""
    grid_y: tuple[int, int]
    """First and last line of the grid in y [cells]."""
    camera: Camera
    """The camera, so that everything is seen."""


def stage_for(
    scene: TfScene, more: Sequence[Vector] = (), *, axis_share: float = AXIS_SHARE
) -> Stage:
    """A stage for the frames of a scene; a metre around the origin if there is nothing.

    Args:
        scene: The frames.
        more: Other points that must be seen, e.g. the corners of a robot [m].
        axis_share: Length of an axis as a share of the way across everything.
    """
    low, high = _bounds([*(pose.origin for pose in scene.poses), *more] or [(0.0, 0.0, 0.0)])
    if math.dist(low, high) < _LEAST_EXTENT:
        low, high = (low[0] - 1.0, low[1] - 1.0, low[2]), (high[0] + 1.0, high[1] + 1.0, high[2])
    extent = math.dist(low, high)
    crowd = min(1.0, math.sqrt(_CROWD / max(len(scene.poses), 1)))
    axis_length, cell = crowd * axis_share * extent, _nice(extent / 8)
    grid_x, grid_y = (_cells(low[i], high[i], cell) for i in (0, 1))
    points = [tip for pose in scene.poses for tip in _tips(pose, axis_length)]
    corners = [(cell * x, cell * y, 0.0) for x in grid_x for y in grid_y]
    camera = Camera(target=low, distance=extent, azimuth=_AZIMUTH, elevation=_ELEVATION)
    return Stage(
        axis_length=axis_length,
        cell=cell,
        grid_x=grid_x,
        grid_y=grid_y,
        camera=fitted(camera, [*points, *more, *corners], fill=0.94),
    )


def _bounds(points: Sequence[Vector]) -> tuple[Vector, Vector]:
    xs, ys, zs = zip(*points, strict=True)
    return (min(xs), min(ys), min(zs)), (max(xs), max(ys), max(zs))


def _tips(pose: FramePose, length: float) -> list[Vector]:
    x, y, z = pose.origin
    return [
        pose.origin,
        *((x + length * a, y + length * b, z + length * c) for a, b, c in pose.axes),
    ]


def _nice(length: float) -> float:
    """The nearest of 1, 2, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(length))
    return min(
        (power, 2 * power, 5 * power, 10 * power), key=lambda nice: abs(math.log(nice / length))
    )


def _cells(low: float, high: float, cell: float) -> tuple[int, int]:
    """Lines around an interval, with room beside it."""
    return math.floor(low / cell - 0.5), math.ceil(high / cell + 0.5)
