"""Meshes: read, bounded, stood in for."""

from __future__ import annotations

import struct

import numpy as np
import pytest

from simkit.physics import plan_robot
from simkit.physics.mesh import CollisionMesh, stand_in
from simkit.urdf import Box, Cylinder, Sphere, read_robot
from simkit.urdf.mesh_file import MAX_BYTES, MeshError, read_mesh


def stl(corners: np.ndarray) -> bytes:
    rows = [struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0) for triangle in corners]
    return bytes(80) + struct.pack("<I", len(rows)) + b"".join(rows)


def prism(sides: int, radius: float, length: float, axis: int) -> np.ndarray:
    """The mantle of a prism along an axis."""
    angles = np.arange(sides + 1) * 2 * np.pi / sides
    ring = np.stack([radius * np.cos(angles), radius * np.sin(angles), np.zeros(sides + 1)], axis=1)
    up = np.array([0, 0, length / 2])
    low, high = ring - up, ring + up
    one = np.stack([low[:-1], low[1:], high[:-1]], axis=1)
    other = np.stack([high[:-1], low[1:], high[1:]], axis=1)
    return np.roll(np.concatenate([one, other]), axis + 1, axis=2)


def ball(radius: float) -> np.ndarray:
    rng = np.random.default_rng(1)
    points = rng.normal(size=(300, 3, 3))
    return radius * points / np.linalg.norm(points, axis=2)[:, :, None]


BOX = np.array([[[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[2, 1, 3], [0, 1, 3], [2, 0, 3]]], float)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_wheel_is_a_cylinder_along_its_axis(axis):
    solid, frame = stand_in(CollisionMesh.of(prism(40, 0.3, 0.1, axis) + np.array([1.0, 2.0, 3.0])))
    assert isinstance(solid, Cylinder)
    assert (solid.radius, solid.length) == pytest.approx((0.3, 0.1))
    assert frame.translation == pytest.approx((1.0, 2.0, 3.0))
    along = np.array(frame.matrix) @ [0.0, 0.0, 1.0]
    assert np.abs(along) == pytest.approx(np.eye(3)[axis])
    assert np.linalg.det(np.array(frame.matrix)) == pytest.approx(1.0)


def test_a_ball_is_a_sphere_and_a_box_a_box():
    solid, _ = stand_in(CollisionMesh.of(ball(0.5)))
    assert isinstance(solid, Sphere)
    assert solid.radius == pytest.approx(0.5, rel=0.02)
    solid, frame = stand_in(CollisionMesh.of(BOX))
    assert solid == Box((2.0, 1.0, 3.0))
    assert frame.translation == (1.0, 0.5, 1.5)


def test_a_flat_mesh_has_a_thickness():
    solid, _ = stand_in(CollisionMesh.of(BOX[:1]))
    assert min(solid.size) == 1e-4


def test_an_stl_file_is_read_and_scaled(tmp_path):
    path = tmp_path / "a.stl"
    path.write_bytes(stl(BOX))
    corners = read_mesh(path, (0.1, 0.1, -1.0)).corners
    assert corners.reshape(-1, 3).max(axis=0) == pytest.approx([0.2, 0.1, 0.0])
    assert corners.reshape(-1, 3).min(axis=0) == pytest.approx([0.0, 0.0, -3.0])


def test_an_obj_file_is_read(tmp_path):
    path = tmp_path / "a.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert read_mesh(path, (1.0, 1.0, 1.0)).corners.shape == (1, 3, 3)


@pytest.mark.parametrize(
    ("name", "data"),
    [("a.stl", b""), ("a.stl", b"solid"), ("a.xyz", b"1 2 3"), ("a.obj", b"\xff\xfe")],
)
def test_a_file_that_is_no_mesh_says_why(tmp_path, name, data):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(MeshError):
        read_mesh(path, (1.0, 1.0, 1.0))


def test_a_file_that_is_not_there_or_too_long_says_so(tmp_path):
    with pytest.raises(MeshError, match="No such file"):
        read_mesh(tmp_path / "a.stl", (1.0, 1.0, 1.0))
    path = tmp_path / "long.stl"
    with path.open("wb") as file:
        file.truncate(MAX_BYTES + 1)
    with pytest.raises(MeshError, match="longer than 50 MB"):
        read_mesh(path, (1.0, 1.0, 1.0))


def test_a_robot_with_a_mesh_rolls_on_what_stands_in_for_it(tmp_path, new_world, at):
    (tmp_path / "wheel.stl").write_bytes(stl(prism(40, 0.3, 0.1, 1)))
    text = """<robot name="r"><link name="a"><inertial><mass value="1"/>
      <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
      <collision><geometry><mesh filename="wheel.stl"/></geometry></collision></link></robot>"""
    robot = read_robot(text, file=str(tmp_path / "r.urdf")).robot
    plan = plan_robot(robot)
    assert "a cylinder of radius 0.3 m and length 0.1 m around it" in plan.notes[0]
    world = new_world()
    wheel = world.add(plan, pose=at(z=0.3))
    world.run(100_000_000)
    wheel.set_twist((0.3, 0.0, 0.0), (0.0, 1.0, 0.0))
    world.run(1_000_000_000)
    assert wheel.pose.translation[0] == pytest.approx(0.3, abs=0.01)
    assert wheel.pose.translation[2] == pytest.approx(0.3, abs=1e-3)
    # a laser sees the triangles: a prism's flat sides, and no caps
    x = wheel.pose.translation[0]
    hits = world.cast_rays((x, -2.0, 0.3), [(0.0, 1.0, 0.0)])
    assert np.isinf(hits.distances[0])
