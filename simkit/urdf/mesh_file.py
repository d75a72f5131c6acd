"""Files of meshes: read by trimesh, bounded in size, and nothing that they refer to.

trimesh loads slowly, so it is imported when the first mesh is met.
"""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

from simkit.errors import SimkitError

FORMATS = (".dae", ".obj", ".stl")
"""Kinds of files, as RViz and Gazebo read them."""
MAX_BYTES = 50_000_000
"""Longest file."""


class MeshError(SimkitError):
    """A file that gives no mesh; one clause says why."""


def load_mesh(path: Path) -> Any:
    """The surface in a file, as a `trimesh.Trimesh` with one triangle at least.

    Only the file itself is read: no pictures, no libraries of materials.

    Args:
        path: The file.

    Raises:
        MeshError: It is not there, of another kind, broken, empty, or too long.
    """
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise MeshError(f"only {', '.join(FORMATS)} are read")
    try:
        if path.stat().st_size > MAX_BYTES:
            raise MeshError(f"it is longer than {MAX_BYTES // 1_000_000} MB")
        data = path.read_bytes()
    except OSError as error:
        raise MeshError(str(error.strerror)) from error
    mesh = _parsed(data, suffix)
    if not len(getattr(mesh, "faces", ())):
        raise MeshError("there are no triangles in it")
    return mesh


def _parsed(data: bytes, suffix: str) -> Any:
    import trimesh

    try:
        # From bytes, trimesh has no folder in which to look for more files.
        return trimesh.load_mesh(io.BytesIO(data), file_type=suffix[1:], process=False)
    except ImportError as error:
        raise MeshError(f"this Python lacks what {suffix} needs: {error}") from error
    except Exception as error:  # broken files end in errors of every kind
        raise MeshError(f"it is broken ({type(error).__name__}: {error})") from error
