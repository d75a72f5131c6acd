"""Shapes as triangles with shaded corners: what the picture without a browser is made of."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from simkit.geometry import Quaternion, Vector, matrix_from_quaternion
from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.parts import SolidShape, TriangleMesh

Array: TypeAlias = NDArray[np.float64]

_ROUND = 40
"So many sides stand for a circle."


@dataclass(frozen=True, slots=True, eq=False)
class Surface:
    """Triangles, each with corners of its own."""

    corners: Array
    """Shape (n, 3, 3): triangle, corner, x y z [m]; counter-clockwise from outside."""
    normals: Array
    """The same shape: directions away from the surface at each corner, of unit length."""

    def placed(
        self, translation: Vector, rotation: Quaternion, scale: Vector = (1.0, 1.0, 1.0)
    ) -> Surface:
        """The surface scaled along its own axes, turned, and moved."""
        turn = rotation_array(rotation)
        factors = np.array(scale)
        normals = self.normals / np.where(factors, factors, 1.0) @ turn.T
        lengths = np.linalg.norm(normals, axis=2, keepdims=True)
        corners = self.corners * factors @ turn.T + np.array(translation)
        return Surface(corners, normals / np.where(lengths, lengths, 1.0))


def surface_of(shape: SolidShape) -> Surface:
    """A shape around its origin; a cylinder stands along z."""
    match shape:
        case Box(size=size):
            return unit_box().placed((0, 0, 0), (0, 0, 0, 1), size)
        case Cylinder(radius=r, length=length):
            return unit_cylinder(_ROUND).placed((0, 0, 0), (0, 0, 0, 1), (r, r, length))
        case Sphere(radius=r):
            return unit_sphere().placed((0, 0, 0), (0, 0, 0, 1), (r, r, r))
        case TriangleMesh(vertices=vertices, triangles=triangles):
            points = np.frombuffer(vertices, "<f4").astype(float).reshape(-1, 3)
            return flat(points[np.frombuffer(triangles, "<u4").reshape(-1, 3)])


def joined_surfaces(surfaces: Sequence[Surface]) -> Surface:
    """Several surfaces as one."""
    return Surface(
        np.concatenate([surface.corners for surface in surfaces]),
        np.concatenate([surface.normals for surface in surfaces]),
    )


def flat(corners: Array) -> Surface:
    """Triangles that are lit as flat pieces."""
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(sides, axis=1, keepdims=True)
    normals = sides / np.where(lengths, lengths, 1.0)
    return Surface(corners, np.repeat(normals[:, None, :], 3, axis=1))


@cache
def unit_box() -> Surface:
    """A box with sides of length 1."""
    faces = []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            middle = sign * np.eye(3)[axis]
            a, b, c, d = (
                (middle + su * u + sv * v) / 2 for su, sv in ((-1, -1), (1, -1), (1, 1), (-1, 1))
            )
            faces += [(a, b, c), (a, c, d)] if sign > 0 else [(a, c, b), (a, d, c)]
    return flat(np.array(faces))


@cache
def unit_cylinder(sides: int, top: float = 1.0) -> Surface:
    """A cylinder of radius 1 and height 1 along z, its middle in the origin.

    Args:
        sides: So many.
        top: Radius of the upper end; 0 for a cone.
    """
    angles = 2 * math.pi * np.arange(sides + 1) / sides
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)
    up = np.array([0.0, 0.0, 1.0])
    low, high = ring - up / 2, ring * top + up / 2
    round_normals = ring + (1.0 - top) * up
    round_normals /= np.linalg.norm(round_normals, axis=1, keepdims=True)
    here, there = slice(None, -1), slice(1, None)
    corners = [
        np.stack([low[here], low[there], high[there]], axis=1),
        np.stack([low[here], high[there], high[here]], axis=1),
    ]
    normals = [
        np.stack([round_normals[here], round_normals[there], round_normals[there]], axis=1),
        np.stack([round_normals[here], round_normals[there], round_normals[here]], axis=1),
    ]
    for end, order, direction in ((low, -1, -1.0), (high, 1, 1.0)):
        middle = np.broadcast_to((0.0, 0.0, direction / 2), (sides, 3))
        pair = (end[here], end[there])[::order]
        corners.append(np.stack([middle, *pair], axis=1))
        normals.append(np.broadcast_to((0.0, 0.0, direction), (sides, 3, 3)))
    return Surface(np.concatenate(corners), np.concatenate(normals))


@cache
def unit_sphere(rings: int = 20) -> Surface:
    """A sphere of radius 1."""
    polar = math.pi * np.arange(rings + 1) / rings
    angles = math.pi * np.arange(2 * rings + 1) / rings
    points = np.stack(
        [
            np.outer(np.sin(polar), np.cos(angles)),
            np.outer(np.sin(polar), np.sin(angles)),
            np.outer(np.cos(polar), np.ones_like(angles)),
        ],
        axis=2,
    )
    a, b = points[:-1, :-1].reshape(-1, 3), points[1:, :-1].reshape(-1, 3)
    c, d = points[1:, 1:].reshape(-1, 3), points[:-1, 1:].reshape(-1, 3)
    corners = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return Surface(corners, corners)


def rotation_array(q: Quaternion) -> Array:
    """The rotation matrix of a quaternion of unit length, shape (3, 3)."""
    return np.array(matrix_from_quaternion(q))
