"""How large a mesh is: from STL and OBJ files, without a library."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Iterator
from pathlib import Path

_LARGEST_BYTES = 20_000_000
"Larger files take too long to look at."
_HEADER = struct.Struct("<80xI")
_FACET = struct.Struct("<12x9f2x")


def mesh_extent(path: Path) -> tuple[float, float, float] | None:
    """Lengths of the mesh along x, y, z, in the unit of the file; None if it cannot be told."""
    suffix = path.suffix.lower()
    try:
        if suffix not in (".stl", ".obj") or path.stat().st_size > _LARGEST_BYTES:
            return None
        data = path.read_bytes()
    except OSError:
        return None
    if suffix == ".stl" and _is_binary(data):
        return _extent(_binary_points(data))
    return _extent(_text_points(data, b"vertex" if suffix == ".stl" else b"v"))


def _is_binary(data: bytes) -> bool:
    if len(data) < _HEADER.size:
        return False
    count: int = _HEADER.unpack_from(data)[0]
    return len(data) == _HEADER.size + count * _FACET.size


def _binary_points(data: bytes) -> Iterator[tuple[float, ...]]:
    for facet in _FACET.iter_unpack(data[_HEADER.size :]):
        yield facet[0:3]
        yield facet[3:6]
        yield facet[6:9]


def _text_points(data: bytes, word: bytes) -> Iterator[tuple[float, ...]]:
    for line in data.splitlines():
        words = line.split()
        if len(words) >= 4 and words[0] == word:
            try:
                yield (float(words[1]), float(words[2]), float(words[3]))
            except ValueError:
                continue


def _extent(points: Iterable[tuple[float, ...]]) -> tuple[float, float, float] | None:
    columns = list(zip(*points, strict=True))
    if not columns:
        return None
    x, y, z = (max(column) - min(column) for column in columns)
    return (x, y, z)
