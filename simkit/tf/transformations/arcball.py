"""The virtual trackball: turns what a mouse drags over a window into a rotation.

Source:
    K. Shoemake, "ARCBALL: a user interface for specifying three-dimensional orientation using a mouse", 1992; names and
    arguments of tf 1.13.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from simkit.tf.transformations.quaternions import (
    quaternion_from_matrix,
    quaternion_matrix,
    quaternion_multiply,
    quaternion_slerp,
)
from simkit.tf.transformations.vectors import Array


def arcball_map_to_sphere(point: ArrayLike, center: Sequence[float], radius: float) -> Array:
    """The point of the unit sphere that lies under a point of the window.

    Args:
        point: Window coordinates (2,), y downwards [px].
        center: Of the ball, in the window [px].
        radius: Of the ball [px].

    Returns:
        Unit vector (3,): x to the right, y up, z towards the viewer; on the rim for points beside the ball.
    """
    x, y = np.asarray(point, dtype=float)[:2]
    across, up = (x - center[0]) / radius, (center[1] - y) / radius
    squared = across * across + up * up
    if squared > 1.0:
        return np.array([across, up, 0.0]) / math.sqrt(squared)
    return np.array([across, up, math.sqrt(1.0 - squared)])


def arcball_constrain_to_axis(point: ArrayLike, axis: ArrayLike) -> Array:
    """The nearest point of the unit sphere on the great circle around an axis, on the viewer's side.

    Args:
        point: Unit vector (3,).
        axis: Unit vector (3,), the pole of the circle.
    """
    pole = np.asarray(axis, dtype=float)
    on_plane = np.asarray(point, dtype=float)
    on_plane = on_plane - pole * np.dot(pole, on_plane)
    length = float(np.linalg.norm(on_plane))
    if length > np.finfo(float).eps:
        nearest: Array = on_plane * (math.copysign(1.0, on_plane[2] + 0.0) / length)
        return nearest
    # The pole itself is as near to every point of its circle: take one that lies level.
    if pole[2] == 1.0:
        return np.array([1.0, 0.0, 0.0])
    level = np.array([-pole[1], pole[0], 0.0])
    level_axis: Array = level / np.linalg.norm(level)
    return level_axis


def arcball_nearest_axis(point: ArrayLike, axes: Sequence[ArrayLike]) -> ArrayLike:
    """That of `axes` (each (3,)) whose great circle passes nearest to a point (3,) of the sphere."""
    where = np.asarray(point, dtype=float)
    return max(axes, key=lambda axis: float(np.dot(arcball_constrain_to_axis(where, axis), where)))


class Arcball:
    """A trackball in a window.

    `down` where the mouse button goes down, `drag` where the mouse goes, `matrix` for the result.

    Args:
        initial: Rotation to begin with: a quaternion (4,) xyzw or a matrix (4, 4); none if None.
    """

    def __init__(self, initial: ArrayLike | None = None) -> None:
        given = np.array([0.0, 0.0, 0.0, 1.0] if initial is None else initial, dtype=float)
        if given.shape == (4, 4):
            given = quaternion_from_matrix(given)
        if given.shape != (4,):
            raise ValueError("initial must be a quaternion (x, y, z, w) or a 4x4 matrix")
        self._center: Sequence[float] = (0.0, 0.0)
        self._radius = 1.0
        self._axes: list[Array] | None = None
        self._axis: ArrayLike | None = None
        self._constrain = False
        self._start = np.array([0.0, 0.0, 1.0])
        self._at_down = given / np.linalg.norm(given)
        self._before = self._now = self._at_down

    def place(self, center: Sequence[float], radius: float) -> None:
        """Put the ball into the window: centre [px] and radius [px]."""
        self._center, self._radius = center, float(radius)

    def setaxes(self, *axes: ArrayLike) -> None:
        """Axes (3,) to which a constrained drag keeps."""
        self._axes = [np.asarray(axis, dtype=float) / np.linalg.norm(axis) for axis in axes]

    def setconstrain(self, constrain: bool) -> None:
        """Keep drags to the axes, or let them free."""
        self._constrain = bool(constrain)

    def getconstrain(self) -> bool:
        """Whether drags keep to the axes."""
        return self._constrain

    def down(self, point: ArrayLike) -> None:
        """The mouse button goes down at a point (2,) of the window."""
        self._start = arcball_map_to_sphere(point, self._center, self._radius)
        self._at_down = self._before = self._now
        self._axis = None
        if self._constrain and self._axes:
            self._axis = arcball_nearest_axis(self._start, self._axes)
            self._start = arcball_constrain_to_axis(self._start, self._axis)

    def drag(self, point: ArrayLike) -> None:
        """The mouse goes to a point (2,) of the window with its button down."""
        end = arcball_map_to_sphere(point, self._center, self._radius)
        if self._axis is not None:
            end = arcball_constrain_to_axis(end, self._axis)
        self._before = self._now
        turn = np.append(np.cross(self._start, end), np.dot(self._start, end))
        if np.dot(turn[:3], turn[:3]) < np.finfo(float).eps:
            self._now = self._at_down
        else:
            self._now = quaternion_multiply(turn, self._at_down)

    def next(self, acceleration: float = 0.0) -> None:
        """Go on turning as the last drag did, slower or faster by `acceleration`."""
        following = quaternion_slerp(self._before, self._now, 2.0 + acceleration, 0, False)
        self._before, self._now = self._now, following

    def matrix(self) -> Array:
        """The rotation so far, as a matrix (4, 4)."""
        return quaternion_matrix(self._now)
