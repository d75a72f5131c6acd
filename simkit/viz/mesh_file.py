"""Meshes of robots: a file of triangles, read by trimesh, bounded in size.

trimesh loads slowly, so it is imported only when a robot has a mesh.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from simkit.errors import SimkitError
from simkit.tf.transform import Vector
from simkit.viz.solid import TriangleMesh

FORMATS = (".dae", ".obj", ".stl")
"""Kinds of files, as RViz reads them."""
MAX_BYTES = 50_000_000
"""Longest file."""
MAX_TRIANGLES = 200_000
"""More triangles than this would choke a notebook."""


class MeshError(SimkitError):
    """A file that gives no mesh; one clause says why."""


def read_mesh(path: Path, scale: Vector) -> TriangleMesh:
    """The triangles of a file.

    Only the file itself is read, not what it refers to: no pictures, no libraries of materials.

    Args:
        path: The file.
        scale: Factors along x, y and z.

    Raises:
        MeshError: It is not there, of another kind, broken, or too large.
    """
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise MeshError(f"only {', '.join(FORMATS)} are drawn")
    try:
        if path.stat().st_size > MAX_BYTES:
            raise MeshError(f"it is longer than {MAX_BYTES // 1_000_000} MB")
        data = path.read_bytes()
    except OSError as error:
        raise MeshError(str(error.strerror)) from error
    return _packed(_loaded(data, suffix), scale)


def _loaded(data: bytes, suffix: str) -> Any:
    import trimesh

    try:
        # From bytes, trimesh has no folder in which to look for more files.
        mesh: Any = trimesh.load_mesh(io.BytesIO(data), file_type=suffix[1:], process=False)
    except ImportError as error:
        raise MeshError(f"this Python lacks what {suffix} needs: {error}") from error
    except Exception as error:  # broken files end in errors of every kind
        raise MeshError(f"it is broken ({type(error).__name__}: {error})") from error
    if not len(getattr(mesh, "faces", ())):
        raise MeshError("there are no triangles in it")
    if len(mesh.faces) > MAX_TRIANGLES:
        raise MeshError(f"it has {len(mesh.faces)} triangles, more than {MAX_TRIANGLES}")
    return mesh


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
