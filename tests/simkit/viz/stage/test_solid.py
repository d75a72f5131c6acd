from __future__ import annotations

from simkit.urdf import Box, Cylinder, Sphere
from simkit.viz.stage.solid import TriangleMesh, half_extents


def test_the_box_around_each_shape():
    origin = (0, 0, 0)
    assert half_extents(Box((1.0, 2.0, 3.0))) == (origin, (0.5, 1.0, 1.5))
    assert half_extents(Cylinder(0.1, 2.0)) == (origin, (0.1, 0.1, 1.0))
    assert half_extents(Sphere(2.0)) == (origin, (2, 2, 2))
    mesh = TriangleMesh(vertices=b"", triangles=b"", low=(0, 0, 2), high=(1, 4, 4))
    assert half_extents(mesh) == ((0.5, 2.0, 3.0), (0.5, 2.0, 1.0))
