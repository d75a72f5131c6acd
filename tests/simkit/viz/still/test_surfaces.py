from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.parts import TriangleMesh
from simkit.viz.still.surfaces import surface_of, unit_cylinder

TETRAHEDRON = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], "<f4")
MESH = TriangleMesh(
    vertices=TETRAHEDRON.tobytes(),
    triangles=np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)], "<u4").tobytes(),
    low=(0, 0, 0),
    high=(1, 1, 1),
)
SHAPES = [
    (Box((1.0, 2.0, 3.0)), 6.0),
    (Cylinder(0.5, 3.0), math.pi * 0.75),
    (Sphere(2.0), math.pi * 32 / 3),
    (MESH, 1 / 6),
]


def volume(surface):
    """By the divergence theorem: right only for a closed surface whose triangles all face outwards."""
    a, b, c = (surface.corners[:, i] for i in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


@pytest.mark.parametrize(("shape", "expected"), SHAPES)
def test_surfaces_are_closed_and_face_outwards(shape, expected):
    assert volume(surface_of(shape)) == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize(("shape", "_expected"), SHAPES)
def test_normals_have_unit_length_and_point_outwards(shape, _expected):
    surface = surface_of(shape)
    assert np.linalg.norm(surface.normals, axis=2) == pytest.approx(1)
    a, b, c = (surface.corners[:, i] for i in range(3))
    outwards = np.einsum("ij,ij->i", np.cross(b - a, c - a), surface.normals.sum(axis=1))
    assert (outwards > -1e-12).all()


def test_a_cylinder_stands_along_z():
    # In three.js it lies along y; there the script of the page turns it.
    corners = surface_of(Cylinder(0.1, 0.5)).corners.reshape(-1, 3)
    assert corners.max(axis=0) == pytest.approx((0.1, 0.1, 0.25))
    assert corners.min(axis=0) == pytest.approx((-0.1, -0.1, -0.25))


def test_a_cone_points_along_z():
    corners = unit_cylinder(8, 0.0).corners.reshape(-1, 3)
    top = corners[corners[:, 2] > 0]
    assert top[:, :2] == pytest.approx(0)


def test_a_surface_is_scaled_then_turned_then_moved():
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    placed = surface_of(Box((1.0, 1.0, 1.0))).placed((10, 0, 0), quarter, (4, 2, 1))
    corners = placed.corners.reshape(-1, 3)
    assert corners.max(axis=0) == pytest.approx((11, 2, 0.5))
    assert corners.min(axis=0) == pytest.approx((9, -2, -0.5))
    assert volume(placed) == pytest.approx(8)
