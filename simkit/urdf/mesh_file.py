"""Files of meshes: read by trimesh, bounded in size, and nothing that they refer to.

trimesh loads slowly, so it is imported when the first mesh is met.
"""

from __future__ import annotations

import io
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError
from simkit.geometry import Vector

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

FORMATS = (".dae", ".obj", ".stl")
"""Kinds of files, as RViz and Gazebo read them."""
MAX_BYTES = 50_000_000
"""Longest file."""
_UNIT = re.compile(rb"""<unit\b[^<>]*?\bmeter\s*=\s*["']\s*([0-9.eE+-]+)\s*["']""")
# No robot of the course has such a mesh, so the library for them is no dependency of this package.
_TO_READ_DAE = "trimesh needs one more library: pip install pycollada"


class MeshError(SimkitError):
    """A file that gives no mesh; one clause says why."""


@dataclass(frozen=True, slots=True, eq=False)
class MeshArrays:
    """A surface of triangles."""

    vertices: NDArray[np.float64]
    """Corners [m], shape (n, 3)."""
    triangles: NDArray[np.int64]
    """Numbers of three corners each, counter-clockwise from outside, shape (m, 3); one at least."""

    @property
    def corners(self) -> NDArray[np.float64]:
        """Corners of the triangles [m], shape (m, 3, 3): triangle, corner, coordinate."""
        return self.vertices[self.triangles]


def read_mesh(path: Path, scale: Vector) -> MeshArrays:
    """The surface in a file.

    Only the file itself is read: no pictures, no libraries of materials.

    Args:
        path: An STL, OBJ or DAE file.
        scale: Factors along x, y and z.

    Raises:
        MeshError: It is not there, of another kind, broken, empty, or too long.
    """
    import numpy as np

    mesh = _loaded(path)
    vertices = np.asarray(mesh.vertices, dtype=np.float64) * np.array(scale)
    triangles = np.asarray(mesh.faces)
    if not np.isfinite(vertices).all() or triangles.min() < 0 or triangles.max() >= len(vertices):
        raise MeshError("it is broken (invalid numbers)")
    if np.prod(scale) < 0.0:
        triangles = triangles[:, ::-1]  # a mirror turns the inside out
    return MeshArrays(vertices, triangles)


def _loaded(path: Path) -> Any:
    """The file as a `trimesh.Trimesh`."""
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
        mesh = trimesh.load_mesh(io.BytesIO(data), file_type=suffix[1:], process=False)
        if suffix == ".dae":
            mesh.apply_scale(metres_of_unit(data))  # type: ignore[no-untyped-call]
        return mesh
    except ImportError as error:
        raise MeshError(f"to read {suffix} files, {_TO_READ_DAE}") from error
    except Exception as error:  # broken files end in errors of every kind
        raise MeshError(f"it is broken ({type(error).__name__}: {error})") from error


def metres_of_unit(data: bytes) -> float:
    """How long the unit of a COLLADA file is [m]; a metre if it does not say.

    Source:
        RViz' mesh loader, which minds `<unit meter="0.01"/>`, and takes no notice of `<up_axis>`.
    """
    found = _UNIT.search(data)
    return float(found[1]) if found else 1.0
