"""Meshes of robots, as a view draws them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from simkit.geometry import Vector
from simkit.urdf.mesh_file import MeshError, load_mesh
from simkit.viz.solid import TriangleMesh

MAX_TRIANGLES = 200_000
"""More triangles than this would choke a notebook."""


def read_mesh(path: Path, scale: Vector) -> TriangleMesh:
    """The triangles of a file.

    Args:
        path: The file.
        scale: Factors along x, y and z.

    Raises:
        MeshError: It is not there, of another kind, broken, or too large.
    """
    mesh = load_mesh(path)
    if len(mesh.faces) > MAX_TRIANGLES:
        raise MeshError(f"it has {len(mesh.faces)} triangles, more than {MAX_TRIANGLES}")
    return _packed(mesh, scale)


def _packed(mesh: Any, scale: Vector) -> TriangleMesh:
    import numpy as np

    vertices = np.asarray(mesh.vertices, dtype=float) * np.array(scale)
    triangles = np.asarray(mesh.faces)
    if not np.isfinite(vertices).all() or triangles.min() < 0 or triangles.max() >= len(vertices):
        raise MeshError("it is broken (numbers that are none)")
    if np.prod(scale) < 0.0:
        triangles = triangles[:, ::-1]  # a mirror turns the inside out
    low, high = (tuple(map(float, bound)) for bound in (vertices.min(0), vertices.max(0)))
    return TriangleMesh(
        vertices=vertices.astype("<f4").tobytes(),
        triangles=triangles.astype("<u4").tobytes(),
        low=(low[0], low[1], low[2]),
        high=(high[0], high[1], high[2]),
    )
