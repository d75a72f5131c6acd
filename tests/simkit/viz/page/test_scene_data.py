from __future__ import annotations

import base64
import json
import struct

import pytest

from simkit.viz.page.scene_data import scene_data
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.scene import make_scene
from simkit.viz.stage.solid import Role, Solid, TriangleMesh


def data(*arguments, **options):
    return json.loads(json.dumps(scene_data(make_scene(*arguments, **options)), allow_nan=False))


def test_frames_are_the_poses(turtles):
    found = data(turtles, fixed_frame="world")
    frames = {frame["label"]: frame for frame in found["frames"]}
    assert [frame["parent"] for frame in found["frames"]] == [None, 0, 1, 0]
    assert [name for name, frame in frames.items() if frame["isFixed"]] == ["world"]
    pose = turtles.core.lookup("world", "carrot1")
    assert frames["carrot1"]["p"] == pytest.approx(pose.translation, abs=1e-6)
    assert frames["carrot1"]["q"] == pytest.approx(pose.rotation, abs=1e-6)


def test_shapes_hang_on_their_frames(arm_frames, arm):
    found = data(arm_frames, fixed_frame="world", robot=arm)
    labels = [frame["label"] for frame in found["frames"]]
    shapes = [(labels[s["frame"]], s["role"], s["kind"], s["size"]) for s in found["solids"]]
    assert shapes == [
        ("base_link", "visual", "cylinder", [0.1, 0.05]),
        ("torso", "visual", "cylinder", [0.05, 0.5]),
        ("torso", "collision", "box", [0.1, 0.1, 0.5]),
        ("upper_arm", "visual", "cylinder", [0.05, 0.4]),
    ]
    upper_arm = found["solids"][-1]
    assert (upper_arm["color"], upper_arm["alpha"]) == ("#ff8000", 0.5)
    assert (upper_arm["p"], upper_arm["q"]) == ([0, 0, 0.2], [0, 0, 0, 1])


def test_lost_shapes_hang_on_nothing_and_are_white(buffer, arm):
    found = data(buffer, fixed_frame="map", robot=arm)
    assert {(s["frame"], s["color"]) for s in found["solids"]} == {(None, "#ffffff")}


def test_a_mesh_is_there_once_however_often_it_is_used(arm_frames):
    mesh = TriangleMesh(
        vertices=struct.pack("<9f", *range(9)),
        triangles=struct.pack("<3I", 0, 1, 2),
        low=(0, 1, 2),
        high=(6, 7, 8),
    )
    solids = [Solid(link="torso", role=role, shape=mesh, color=(1, 1, 1)) for role in Role]
    robot = RobotShapes(links=("torso",), solids=tuple(solids))
    found = data(arm_frames, fixed_frame="world", robot=robot)
    assert [(solid["kind"], solid["size"]) for solid in found["solids"]] == [("mesh", [0])] * len(
        Role
    )
    (sent,) = found["meshes"]
    assert base64.b64decode(sent["vertices"]) == mesh.vertices
    assert base64.b64decode(sent["triangles"]) == mesh.triangles
