from __future__ import annotations

import math
import struct

import pytest
import trimesh

from simkit.urdf import Box, Cylinder, Sphere, load_robot
from simkit.urdf.mesh_file import MeshError
from simkit.viz.stage import robot as robot_module
from simkit.viz.stage.parts import Role
from simkit.viz.stage.robot import MISSING, TOUCHED, UNPAINTED, drawn_mesh, robot_room, robot_shapes


def shapes(visual, more="", **options):
    text = f'<robot name="r"><link name="a">{visual}</link>{more}</robot>'
    return robot_shapes(load_robot(text, file="r.urdf"), **options)


def a_visual(geometry, material=""):
    return f"<visual><geometry>{geometry}</geometry>{material}</visual>"


@pytest.mark.parametrize(
    ("geometry", "shape"),
    [
        ('<box size="1 2 3"/>', Box((1.0, 2.0, 3.0))),
        ('<cylinder radius="0.1" length="0.5"/>', Cylinder(0.1, 0.5)),
        ('<sphere radius="2"/>', Sphere(2.0)),
    ],
)
def test_shapes_and_their_place(geometry, shape):
    origin = '<origin xyz="1 2 3" rpy="0 0 3.14159265358979"/>'
    (solid,) = shapes(f"<visual>{origin}<geometry>{geometry}</geometry></visual>").solids
    assert (solid.shape, solid.translation, solid.role) == (shape, (1, 2, 3), Role.VISUAL)
    assert [abs(c) for c in solid.rotation] == pytest.approx((0, 0, 1, 0), abs=1e-9)


def test_colours_are_those_of_the_material_and_red_without_one():
    painted = '<material name="m"><color rgba="0.1 0.2 0.3 0.4"/></material>'
    (solid,) = shapes(a_visual('<sphere radius="1"/>', painted), alpha=0.5).solids
    assert solid.color == (0.1, 0.2, 0.3)
    assert solid.alpha == pytest.approx(0.2)
    (bare,) = shapes(a_visual('<sphere radius="1"/>')).solids
    assert (bare.color, bare.alpha) == (UNPAINTED, 1.0)


def test_a_material_may_be_defined_by_another_link(arm):
    torso = next(s for s in arm.solids if s.link == "torso" and s.role is Role.VISUAL)
    assert torso.color == (0.75, 0.75, 0.75)


def test_collision_shapes_have_a_colour_of_their_own(arm):
    (touched,) = [s for s in arm.solids if s.role is Role.COLLISION]
    assert (touched.link, touched.shape, touched.color) == ("torso", Box((0.1, 0.1, 0.5)), TOUCHED)
    assert touched.alpha < 1


def test_a_box_stands_for_a_mesh_that_is_missing():
    found = shapes(a_visual('<mesh filename="package://nobody/hand.stl"/>'))
    (solid,) = found.solids
    assert solid.shape == Box((0.1, 0.1, 0.1))
    assert solid.color == MISSING
    (note,) = found.notes
    assert note.startswith("A box of 0.1 m stands for the mesh package://nobody/hand.stl of [a]: ")


def test_what_is_beyond_all_measure_is_left_out_and_named():
    found = shapes(a_visual('<sphere radius="1e30"/>') + a_visual('<sphere radius="1"/>'))
    assert [solid.shape for solid in found.solids] == [Sphere(1.0)]
    assert found.notes == ("A shape of [a] is too large or too far away to be drawn.",)


def test_a_robot_of_very_many_shapes_is_drawn_in_part():
    found = shapes(a_visual('<sphere radius="1"/>') * 2100)
    assert len(found.solids) == 2000
    assert found.notes == ("Only the first 2000 of 2100 shapes are drawn.",)


CORNERS = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl():
    """A corner of a box: four triangles."""
    data = b"\0" * 80 + struct.pack("<I", len(FACES))
    for face in FACES:
        numbers = [value for corner in face for value in CORNERS[corner]]
        data += struct.pack("<12fH", 0, 0, 0, *numbers, 0)
    return data


def obj(head=""):
    corners = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS)
    return (head + corners + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)).encode()


def triangles(mesh):
    vertices = list(struct.iter_unpack("<3f", mesh.vertices))
    return [[vertices[i] for i in t] for t in struct.iter_unpack("<3I", mesh.triangles)]


@pytest.mark.parametrize(("name", "data"), [("a.stl", stl()), ("A.STL", stl()), ("a.obj", obj())])
def test_triangles_of_a_file(tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    mesh = drawn_mesh(tmp_path / name, (1.0, 1.0, 1.0))
    assert triangles(mesh) == [[CORNERS[i] for i in face] for face in FACES]
    assert (mesh.low, mesh.high) == ((0, 0, 0), (1, 2, 3))


def test_the_scale_and_what_a_mirror_does_to_the_inside(tmp_path):
    (tmp_path / "a.stl").write_bytes(stl())
    mesh = drawn_mesh(tmp_path / "a.stl", (2.0, -1.0, 1.0))
    assert (mesh.low, mesh.high) == ((0, -2, 0), (2, 0, 3))
    assert triangles(mesh)[0] == [(2, 0, 0), (0, -2, 0), (0, 0, 0)]


def test_equal_files_give_equal_meshes(tmp_path):
    for name in ("a.stl", "b.stl"):
        (tmp_path / name).write_bytes(stl())
    assert drawn_mesh(tmp_path / "a.stl", (1, 1, 1)) == drawn_mesh(tmp_path / "b.stl", (1, 1, 1))


def test_a_file_reads_no_other_file(tmp_path):
    (tmp_path / "secret.mtl").write_text("newmtl secret\nKd 1 0 0\n")
    (tmp_path / "a.obj").write_bytes(obj("mtllib secret.mtl\nusemtl secret\n"))
    assert len(triangles(drawn_mesh(tmp_path / "a.obj", (1, 1, 1)))) == 4


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("a.gltf", b"{}", r"only \.dae, \.obj, \.stl are read"),
        ("a.stl", b"", "broken|no triangles"),
        ("a.stl", b"solid of nothing", "broken|no triangles"),
        ("a.obj", b"f 1 2 3\n", "broken|no triangles"),
        ("a.dae", b"<COLLADA/>", "pip install pycollada|broken"),
    ],
)
def test_what_is_no_mesh_is_refused_with_a_reason(tmp_path, name, data, words):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(MeshError, match=words):
        drawn_mesh(tmp_path / name, (1, 1, 1))


@pytest.mark.parametrize(
    ("head", "metres"),
    [
        (b'<unit name="centimeter" meter="0.01"/>', 0.01),
        (b"<unit meter = '2.54e-2' name='inch'/>", 0.0254),
        (b'<unit name="meter"/><p meter="3"/>', 1.0),
        (b"<up_axis>Y_UP</up_axis>", 1.0),
    ],
)
def test_the_unit_of_a_collada_file_counts_as_in_rviz(tmp_path, monkeypatch, head, metres):
    def load(file, **_):
        return trimesh.Trimesh(CORNERS, FACES, process=False)

    monkeypatch.setattr(trimesh, "load_mesh", load)  # as with pycollada, which minds no unit
    (tmp_path / "a.dae").write_bytes(b"<COLLADA><asset>" + head + b"</asset></COLLADA>")
    mesh = drawn_mesh(tmp_path / "a.dae", (1, 1, 2))
    assert mesh.high == pytest.approx((metres, 2 * metres, 6 * metres))


def test_a_file_that_is_not_there_and_one_that_is_too_long(tmp_path, monkeypatch):
    with pytest.raises(MeshError, match="No such file"):
        drawn_mesh(tmp_path / "a.stl", (1, 1, 1))
    (tmp_path / "a.stl").write_bytes(stl())
    monkeypatch.setattr(robot_module, "MAX_TRIANGLES", 3)
    with pytest.raises(MeshError, match="it has 4 triangles, more than 3"):
        drawn_mesh(tmp_path / "a.stl", (1, 1, 1))
    monkeypatch.setattr("simkit.urdf.mesh_file.MAX_BYTES", 100)
    with pytest.raises(MeshError, match="longer than"):
        drawn_mesh(tmp_path / "a.stl", (1, 1, 1))


def room(joint, more=""):
    text = f"""<robot name="r"><link name="a"/>
    <link name="b"><visual>
      <origin xyz="0 0 1"/><geometry><box size="0.2 0.2 2"/></geometry>
    </visual></link>
    <joint name="j" {joint}<parent link="a"/><child link="b"/></joint>{more}</robot>"""
    shapes = robot_shapes(load_robot(text, file="r.urdf"))
    return robot_room(shapes.models[0], shapes.solids)


def bounds(points):
    return [(min(p[axis] for p in points), max(p[axis] for p in points)) for axis in range(3)]


def test_a_link_that_turns_takes_a_whole_circle():
    x, y, z = bounds(room('type="continuous"><axis xyz="1 0 0"/>'))
    assert x == pytest.approx((-0.1, 0.1))
    reach = math.hypot(2, 0.1)
    assert (*y, *z) == pytest.approx((-reach, reach, -reach, reach), rel=0.02)


def test_limits_count():
    limit = '<limit lower="0" upper="1.5708" effort="1" velocity="1"/>'
    _, y, z = bounds(room(f'type="revolute"><axis xyz="1 0 0"/>{limit}'))
    assert y[0] == pytest.approx(-2.0, rel=0.05)
    assert y[1] == pytest.approx(0.1, rel=0.05)
    assert z[0] == pytest.approx(-0.1, rel=0.3)


def test_a_robot_that_does_not_move_takes_its_own_room():
    assert bounds(room('type="fixed">')) == [(-0.1, 0.1), (-0.1, 0.1), (0.0, 2.0)]


def test_there_are_few_points_and_always_the_same(arm):
    points = robot_room(arm.models[0], arm.solids)
    assert points == robot_room(arm.models[0], arm.solids)
    assert 8 <= len(points) <= 26


def test_nothing_to_see_takes_no_room(arm):
    assert robot_room(arm.models[0], ()) == ()
