from __future__ import annotations

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import RvizSettings, SceneSource, robot_displays, scene_source

ROBOT = '<robot name="r"><link name="turtle1"><visual><geometry><sphere radius="1"/></geometry></visual></link></robot>'


@pytest.fixture
def parameters():
    server = ParameterServer()
    server.set("/robot_description", ROBOT)
    return server


def source(buffer, parameters, **settings):
    return SceneSource(
        RvizSettings(**settings), buffer=buffer, parameters=parameters, packages=PackagePath([])
    )


def test_a_scene_is_what_tf_and_the_parameter_say(turtles, parameters):
    scene = source(turtles, parameters).scene()
    (placed,) = scene.solids
    assert placed.pose()[0] == turtles.core.lookup("world", "turtle1").translation


def test_the_robot_is_read_again_only_when_its_description_has_changed(
    turtles, parameters, monkeypatch
):
    read = []
    original = scene_source.described_robot
    monkeypatch.setattr(
        scene_source,
        "described_robot",
        lambda *args, **more: read.append(1) or original(*args, **more),
    )
    watched = source(turtles, parameters)
    first = watched.robot()
    assert watched.robot() is first
    parameters.set("/robot_description", ROBOT.replace("turtle1", "turtle2"))
    assert watched.robot().links == ("turtle2",)
    parameters.delete("/robot_description")
    assert watched.robot() is None
    assert len(read) == 3


def test_another_parameter_and_no_robot(turtles, parameters):
    parameters.set("/arm/description", ROBOT.replace("turtle1", "turtle2"))
    other = source(turtles, parameters, robots=robot_displays("arm/description"))
    assert other.robot().links == ("turtle2",)
    missing = source(turtles, parameters, robots=robot_displays("/nothing")).robot()
    assert missing.errors[0].startswith("Parameter [/nothing] does not exist")
    assert source(turtles, parameters, robot_model=None).robot() is None


def test_without_a_choice_the_fixed_frame_is_one_that_is_there(buffer, parameters):
    def chosen():
        return source(buffer, parameters, fixed_frame="").fixed_frame

    assert chosen() == "map"
    buffer.put("odom", "base_link")
    assert chosen() == "odom"
    buffer.put("world", "odom")
    assert chosen() == "world"
    buffer.put("map", "world")
    assert chosen() == "map"
    assert source(buffer, parameters, fixed_frame="odom").fixed_frame == "odom"


def test_with_room_the_camera_stays_where_it_is_while_joints_move(arm_frames, parameters, arm_text):
    parameters.set("/robot_description", arm_text)

    def cameras(start, *, with_room):
        watched = SceneSource(
            RvizSettings(),
            buffer=arm_frames,
            parameters=parameters,
            packages=PackagePath([]),
            with_room=with_room,
        )
        found = []
        for step, pitch in enumerate((1.5, -0.3), start):
            arm_frames.put(
                "torso", "upper_arm", 1_600_088_401 + step, (0, -0.1, 0.45), (0, pitch, 0)
            )
            arm_frames.put("base_link", "torso", 1_600_088_401 + step, (0, 0, 0.05))
            found.append(watched.scene().stage.camera.distance)
        return found

    near, far = cameras(0, with_room=True)
    assert near == pytest.approx(far, rel=0.02)
    near, far = cameras(2, with_room=False)
    assert near != pytest.approx(far, rel=0.02)


def test_a_complaint_about_the_settings_is_the_first_problem(two_trees, parameters):
    problems = source(two_trees, parameters, complaint="It is broken.").scene().problems
    assert problems[0] == "It is broken."
    assert len(problems) > 4


def test_frames_are_those_of_the_scene(two_trees, parameters):
    watched = source(two_trees, parameters, fixed_frame="map")
    assert watched.frames() == watched.scene().tf


def test_two_robots_stand_each_in_the_frames_of_its_prefix(buffer, parameters, arm_text):
    buffer.put("world", "left/base_link", static=True, xyz=(0, 1, 0))
    buffer.put("world", "right/base_link", static=True, xyz=(0, -1, 0))
    for side in ("left", "right"):
        parameters.set(f"/{side}/robot_description", arm_text)
    robots = robot_displays(
        {"/left/robot_description": "left", "/right/robot_description": "right"}
    )
    watched = SceneSource(
        RvizSettings(robots=robots),
        buffer=buffer,
        parameters=parameters,
        packages=PackagePath([]),
        with_room=True,
    )
    scene = watched.scene()
    assert {s.solid.link: round(s.pose()[0][1]) for s in scene.solids if not s.is_lost} == {
        "left/base_link": 1,
        "right/base_link": -1,
    }
    assert watched.robot() is watched.robot()
    assert (
        "No transform from [left/torso] to [world]: no node broadcasts this link." in scene.problems
    )
    parameters.delete("/right/robot_description")
    assert watched.scene().problems[0].startswith("Parameter [/right/robot_description] does not")
