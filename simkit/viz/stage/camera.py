"""A camera that looks at a point from a distance, as RViz' orbit view does; and a grid and axes of the right size."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

from simkit.geometry import Vector
from simkit.viz.draw.drawing import Point
from simkit.viz.stage.frames import FramePose, TfScene

FIELD_OF_VIEW: Final = math.radians(30.0)
"""Angle that the picture's height covers [rad]."""
_LEAST_DISTANCE = 1e-6
NEAR: Final = 0.02
"""Nearer than this share of the distance nothing is drawn."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Camera:
    """Where it looks from, in the fixed frame, z up."""

    target: Vector
    """The point in the middle of the picture [m]."""
    distance: float
    """From the target to the camera [m]."""
    azimuth: float
    """Direction of the camera seen from the target, counter-clockwise from x [rad]."""
    elevation: float
    """Height of the camera above the target's plane [rad]."""

    @property
    def basis(self) -> tuple[Vector, Vector, Vector]:
        """Unit vectors to the right and up in the picture, and from the target to the camera."""
        sin_a, cos_a = math.sin(self.azimuth), math.cos(self.azimuth)
        sin_e, cos_e = math.sin(self.elevation), math.cos(self.elevation)
        return (
            (-sin_a, cos_a, 0.0),
            (-sin_e * cos_a, -sin_e * sin_a, cos_e),
            (cos_e * cos_a, cos_e * sin_a, sin_e),
        )

    def seen(self, point: Vector) -> Vector:
        """A point [m] as right, up and depth away from the camera [m]."""
        x, y, z = (p - t for p, t in zip(point, self.target, strict=True))
        right, up, back = (a * x + b * y + c * z for a, b, c in self.basis)
        return (right, up, self.distance - back)

    def is_before(self, seen: Vector) -> bool:
        """Whether something is far enough in front of the camera to be drawn."""
        return seen[2] > NEAR * self.distance


def on_paper(seen: Vector, size: Point) -> Point:
    """Where something that is seen lies in a picture of that width and height [px]."""
    width, height = size
    scale = focal_length(size) / seen[2]
    return (width / 2 + seen[0] * scale, height / 2 - seen[1] * scale)


def focal_length(size: Point) -> float:
    """Pixels per metre at a depth of one metre."""
    width, height = size
    return min(height, width / 1.6) / 2 / math.tan(FIELD_OF_VIEW / 2)


def fitted(camera: Camera, points: Sequence[Vector], *, fill: float) -> Camera:
    """The camera in its direction so that all points are seen, near and in the middle.

    Args:
        camera: Gives the direction, and a target among the points.
        points: What must be seen, at least one [m].
        fill: Share of the picture, 1.6 times as wide as high, that the points may take.
    """
    for _ in range(4):
        camera = _centred(_at_least_distance(camera, points, fill), points)
    return _at_least_distance(camera, points, fill)


def _at_least_distance(camera: Camera, points: Sequence[Vector], fill: float) -> Camera:
    tangent = math.tan(FIELD_OF_VIEW / 2) * fill
    distance = _LEAST_DISTANCE
    for point in points:
        right, up, depth = camera.seen(point)
        distance = max(distance, 1.2 * (camera.distance - depth))
        # At the picture's edge |up| = tangent * depth, and depth grows with the distance.
        missing = max(abs(up), abs(right) / 1.6) / tangent - depth
        distance = max(distance, camera.distance + missing)
    return replace(camera, distance=distance)


def _centred(camera: Camera, points: Sequence[Vector]) -> Camera:
    """The camera moved sideways until the points' picture is about in the middle."""
    seen = [camera.seen(point) for point in points]
    across, upwards = ([s[i] / s[2] for s in seen] for i in (0, 1))
    right, up, _ = camera.basis
    x = (min(across) + max(across)) / 2 * camera.distance
    y = (min(upwards) + max(upwards)) / 2 * camera.distance
    tx, ty, tz = (t + x * r + y * u for t, r, u in zip(camera.target, right, up, strict=True))
    return replace(camera, target=(tx, ty, tz))


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
    low, high = bounds([*(pose.origin for pose in scene.poses), *more] or [(0.0, 0.0, 0.0)])
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


def bounds(points: Iterable[Vector]) -> tuple[Vector, Vector]:
    """Least and greatest x, y and z of points, at least one [m]."""
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
