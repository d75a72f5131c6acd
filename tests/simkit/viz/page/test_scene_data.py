from __future__ import annotations

import base64
import json
import struct
from dataclasses import replace

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import RvizSettings, SceneSource
from simkit.viz.page.scene_data import LiveScene, scene_data
from simkit.viz.stage.parts import Marks, Role, Solid, TriangleMesh
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.scene import make_scene


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


START = 1_600_088_400
ROBOT = '<robot name="r"><link name="a"/></robot>'


@pytest.fixture
def parameters():
    return ParameterServer()


@pytest.fixture
def live(turtles, parameters):
    source = SceneSource(
        RvizSettings(), buffer=turtles, parameters=parameters, packages=PackagePath([])
    )
    return LiveScene(source)


def told(state, known=None):
    text = state.changes(known)
    return None if text is None else json.loads(text)


def test_somebody_new_is_told_everything(live):
    found = told(live.look())
    assert [frame["label"] for frame in found["scene"]["frames"]] == [
        *("world", "turtle1", "carrot1", "turtle2")
    ]
    assert set(found["changes"]["poses"]) == {"0", "1", "2", "3"}


def test_who_knows_everything_is_told_nothing(live):
    state = live.look()
    assert told(state, state) is None


def test_only_what_has_moved_is_told(live, turtles):
    before = live.look()
    turtles.put("world", "turtle2", START + 5, (4, 4, 0))
    after = live.look()
    found = told(after, before)
    assert found == {"changes": {"poses": {"3": [4, 4, 0, 0, 0, 0, 1]}}}
    assert after.scene == before.scene


def test_points_and_lines_are_told_when_they_are_others(live):
    contact = Marks(name="contacts", label="Contacts", color="#00ff00", points=((1.0, 2.0, 3.0),))
    state = replace(live.look(), marks=(contact,))
    data = [{"points": [1, 2, 3], "lines": []}]
    assert told(state, live.look()) == {"changes": {"marks": data}}
    assert told(state, state) is None
    # Who gets another scene is told them anew.
    assert told(state, replace(state, number=-1))["changes"]["marks"] == data


@pytest.mark.parametrize("change", ["a frame", "the robot", "beyond the grid", "another parent"])
def test_what_is_new_makes_another_scene(live, turtles, parameters, change):
    before = live.look()
    match change:
        case "a frame":
            turtles.put("world", "late", START)
        case "the robot":
            parameters.set("/robot_description", ROBOT)
        case "beyond the grid":
            turtles.put("world", "turtle2", START + 5, (40, 4, 0))
        case "another parent":
            turtles.put("turtle1", "turtle2", START + 5)
    after = live.look()
    assert after.number == before.number + 1
    assert "scene" in told(after, before)
    assert live.look().number == after.number


def test_without_frames_there_is_a_scene_all_the_same(buffer, parameters):
    source = SceneSource(
        RvizSettings(), buffer=buffer, parameters=parameters, packages=PackagePath([])
    )
    found = told(LiveScene(source).look())
    assert found["scene"]["error"].startswith("No tf data.")
    assert found["changes"] == {}
