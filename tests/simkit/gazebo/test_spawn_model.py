"""The node that spawns: options, texts, exit codes."""

from __future__ import annotations

import pytest

BALL = """<?xml version="1.0"?>
<robot name="ball"><link name="ball">
  <inertial><mass value="1"/><inertia ixx="0.004" iyy="0.004" izz="0.004" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""
WHEEL = """<robot name="wheel"><link name="world"/><link name="wheel">
  <inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
</link><joint name="axle" type="continuous"><parent link="world"/><child link="wheel"/>
  <origin xyz="0 0 1"/><axis xyz="0 0 1"/></joint></robot>"""


def spawn(sim, *arguments):
    """Run it for a while."""
    node = sim.rosrun("gazebo_ros", "spawn_model", *arguments)
    sim.run(0.2)
    return node


def said(sim):
    return [record.text for record in sim.log if record.node == "/spawn_model"]


def test_it_spawns_from_a_parameter_as_the_original_says_it(sim, gazebo):
    sim.params.set("/robot_description", BALL)
    node = spawn(
        sim, "-urdf", "-param", "robot_description", "-model", "ball", "-z", "2", "-Y", "1"
    )
    assert said(sim) == [
        "Loading model XML from ros parameter robot_description",
        "Waiting for service /gazebo/spawn_urdf_model",
        "Calling service /gazebo/spawn_urdf_model",
        "Spawn status: SpawnModel: Successfully spawned entity",
    ]
    assert (node.exit_code, node.alive) == (0, False)
    assert gazebo.spawned["ball"].model.start.translation == (0.0, 0.0, 2.0)
    assert gazebo.spawned["ball"].namespace == "/"


def test_it_spawns_from_a_file(sim, gazebo, tmp_path):
    file = tmp_path / "ball.urdf"
    file.write_text(BALL)
    assert spawn(sim, "-file", str(file), "-urdf", "-z", "1", "-model", "b").exit_code == 0
    assert "b" in gazebo.spawned


def test_the_second_of_a_name_fails_with_the_remedy(sim, gazebo):
    sim.params.set("/robot_description", BALL)
    for code in (0, 1):
        node = spawn(sim, "-urdf", "-param", "robot_description", "-model", "ball", "-z", "1")
        assert node.exit_code == code
    assert "Spawn service failed. Exiting." in said(sim)
    assert any("delete it first" in text for text in said(sim))
    assert len(gazebo.spawned) == 2


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["-urdf", "-sdf", "-param", "p", "-model", "m"],
        ["-urdf", "-model", "m"],
        ["-urdf", "-param", "p"],
        ["-urdf", "-param", "p", "-model", "m", "-x", "one"],
        ["-urdf", "-param", "p", "-model", "m", "-J", "joint", "far"],
        ["-urdf", "-param", "p", "-model", "m", "--speed", "1"],
        ["-urdf", "-database", "coke", "-model", "m"],
    ],
)
def test_a_wrong_command_line_is_explained_and_ends_with_2(sim, arguments):
    node = spawn(sim, *arguments)
    assert node.exit_code == 2
    assert node.output.startswith("usage: spawn_model")
    assert "spawn_model: error:" in node.output


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["-param", "robot_description"], "the parameter /robot_description is not set"),
        (["-file", "/nowhere/r.urdf"], "Error: specified file /nowhere/r.urdf does not exist"),
        (["-param", "broken"], "Invalid XML: "),
    ],
)
def test_what_cannot_be_loaded_is_named(sim, arguments, text):
    sim.params.set("/broken", "<robot name='x'><link></robot>")
    node = spawn(sim, "-urdf", *arguments, "-model", "m")
    assert node.exit_code == 1
    assert any(line.startswith(text) for line in said(sim))


def test_without_a_world_it_waits_and_says_what_is_missing(sim):
    sim.params.set("/robot_description", BALL)
    node = sim.rosrun(
        "gazebo_ros", "spawn_model", "-urdf", "-param", "robot_description", "-model", "m"
    )
    sim.run(6.0)
    assert node.alive
    assert sum("roslaunch gazebo_ros empty_world.launch" in text for text in said(sim)) == 1
    gazebo = sim.gazebo
    sim.run(0.2)
    assert node.exit_code == 0
    assert "m" in gazebo.spawned


def test_it_waits_for_another_model(sim, gazebo):
    sim.params.set("/robot_description", BALL)
    node = spawn(
        sim, "-urdf", "-param", "robot_description", "-model", "b", "-z", "1", "-wait", "first"
    )
    assert node.alive
    gazebo.spawn_urdf(BALL, name="first")
    sim.run(0.2)
    assert node.exit_code == 0


def test_joints_are_set_a_second_later(sim, gazebo):
    sim.params.set("/robot_description", WHEEL)
    node = spawn(
        sim, "-urdf", "-param", "robot_description", "-model", "w", "-J", "axle", "0.5", "-unpause"
    )
    assert gazebo.world.model("w").joint("axle").position == 0.0
    sim.run(1.0)
    assert gazebo.world.model("w").joint("axle").position == pytest.approx(0.5)
    assert node.exit_code == 0


def test_a_bound_model_goes_with_its_node(sim, gazebo):
    sim.params.set("/robot_description", BALL)
    node = spawn(sim, "-urdf", "-param", "robot_description", "-model", "ball", "-b")
    assert node.alive
    node.shutdown()
    assert "ball" not in gazebo.spawned
