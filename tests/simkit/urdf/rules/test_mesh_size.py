"""How large a mesh is, told from its file."""

import struct

import pytest

from simkit.urdf.rules.meshes import mesh_extent

CORNERS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.5), (0.0, 2.0, -0.5)]


def test_a_binary_stl(tmp_path):
    facet = struct.pack("<12fH", 0, 0, 1, *(number for corner in CORNERS for number in corner), 0)
    path = tmp_path / "a.STL"
    path.write_bytes(
        b"solid is a word that binary files begin with, too".ljust(80)
        + struct.pack("<I", 1)
        + facet
    )
    assert mesh_extent(path) == (1.0, 2.0, 1.0)


def test_an_stl_of_text(tmp_path):
    path = tmp_path / "a.stl"
    lines = [f"  vertex {x} {y} {z}" for x, y, z in CORNERS]
    path.write_text("\n".join(["solid a", "outer loop", *lines, "vertex a b c", "endsolid"]))
    assert mesh_extent(path) == (1.0, 2.0, 1.0)


def test_an_obj(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("# a\n" + "".join(f"v {x} {y} {z}\nvn 9 9 9\n" for x, y, z in CORNERS))
    assert mesh_extent(path) == (1.0, 2.0, 1.0)


@pytest.mark.parametrize(
    ("name", "data"), [("a.dae", b"<COLLADA/>"), ("a.stl", b""), ("a.obj", b"\0" * 9)]
)
def test_what_cannot_be_told(tmp_path, name, data):
    path = tmp_path / name
    path.write_bytes(data)
    assert mesh_extent(path) is None
    assert mesh_extent(tmp_path / f"no_{name}") is None
