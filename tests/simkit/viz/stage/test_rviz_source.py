from __future__ import annotations

import pytest

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import RvizSettings, SceneSource
from simkit.viz.stage import rviz_source
from simkit.viz.stage.rviz_settings import RobotDisplay, robot_displays
from simkit.viz.stage.rviz_source import described_robot

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
    original = rviz_source.described_robot
    monkeypatch.setattr(
        rviz_source,
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


ONE_LINK = '<robot name="r"><link name="a"><visual><geometry><sphere radius="1"/></geometry></visual></link></robot>'


def described(value, **options):
    return described_robot(value, PackagePath([]), **options)


def test_a_robot_is_read():
    robot = described(ONE_LINK, alpha=0.25)
    assert robot.errors == ()
    assert robot.links == ("a",)
    assert [solid.alpha for solid in robot.solids] == [0.25]


def test_no_robot_under_the_usual_name_is_nothing_to_speak_of():
    assert described(None) is None


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, "Parameter [/arm] does not exist, and was not found by searchParam()"),
        (42, "Parameter [/arm] is no text: it should hold the URDF of a robot"),
        (" \n", "URDF is empty"),
    ],
)
def test_what_is_wrong_is_said_as_rviz_says_it(value, words):
    robot = described(value, name="/arm")
    assert (robot.errors, robot.solids) == ((words,), ())


def test_a_broken_robot_is_told_in_one_line_with_its_place():
    robot = described(ONE_LINK.replace("</visual>", ""), name="/robot_description")
    assert robot.errors[0].startswith("URDF failed Model parse: /robot_description:1:")
    assert "\n" not in robot.errors[0]


def test_meshes_are_found_in_packages(tmp_path):
    (tmp_path / "hello_ros").mkdir()
    (tmp_path / "hello_ros/package.xml").write_text("<package/>")
    mesh = '<mesh filename="package://hello_ros/hand.obj"/>'
    text = ONE_LINK.replace('<sphere radius="1"/>', mesh)
    packages = PackagePath([tmp_path])
    assert len(described_robot(text, packages).notes) == 1
    (tmp_path / "hello_ros/hand.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    robot = described_robot(text, packages)
    assert robot.notes == ()
    assert robot.solids[0].shape.high == (1, 1, 0)


def test_all_faults_of_a_robot_that_is_refused_are_told_each_in_a_line():
    joint = '<joint name="j{0}" type="{1}"><parent link="a"/><child link="b{0}"/></joint>'
    faulty = "\n".join(joint.format(number, "turns") for number in range(2))
    errors = described(ONE_LINK.replace("</robot>", f"{faulty}</robot>")).errors
    assert errors[0].startswith("URDF failed Model parse: /robot_description:1:")
    assert len(errors) == len(set(errors)) > 2
    assert all(error.startswith("/robot_description:") for error in errors[1:])
    assert not [error for error in errors if "\n" in error]
    many = "\n".join(joint.format(number, "turns") for number in range(40))
    errors = described(ONE_LINK.replace("</robot>", f"{many}</robot>")).errors
    assert len(errors) == 8
    assert errors[-1].endswith("more: simkit check_urdf shows them all.")


def test_a_prefix_stands_before_each_link():
    robot = described(ONE_LINK, tf_prefix="left")
    assert robot.links == ("left/a",)
    assert robot.solids[0].link == "left/a"


def test_which_robots_a_person_asks_for():
    assert robot_displays("/arm") == robot_displays(["/arm"]) == (RobotDisplay("/arm"),)
    assert robot_displays({"/l/arm": "/l/", "/r/arm": ""}) == (
        RobotDisplay("/l/arm", "l"),
        RobotDisplay("/r/arm", ""),
    )
