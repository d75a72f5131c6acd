"""Launch files: those that need no simulated world run, the others are without a fault but for what is not there yet."""

from __future__ import annotations

import re
import shutil

import pytest

from simkit import Simulation
from simkit.graph import LogLevel
from simkit.launch import evaluate
from simkit.packages import PackagePath
from simkit.xml import parse_xml

FRAMES = {
    "urdf_launch_1": [],  # it loads the robot, and starts no node
    "urdf_launch_2": ["base_link", "torso", "world"],
    "urdf_launch_3": ["base_link", "torso", "upper_arm", "world"],
}
PUBLISHER = ("robot_state_publisher", "robot_state_publisher")
SPAWNER = ("gazebo_ros", "spawn_model")
WITH_A_WORLD = {
    "spawn_gazebo_1": [SPAWNER],
    "spawn_gazebo_2": [SPAWNER, ("controller_manager", "spawner"), PUBLISHER],
    "spawn_urdf": [SPAWNER, PUBLISHER],
    "practice_world": [],
}
EMPTY_WORLD = """\
<launch>
  <arg name="world_name" default="worlds/empty.world"/>
  <param name="/use_sim_time" value="true"/>
  <param name="/stand_in/world_name" value="$(arg world_name)"/>
</launch>
"""
"""In the place of the launch file of gazebo_ros; it tells which world it was asked for."""


@pytest.fixture
def stand_in(robots, tmp_path):
    """The packages, and a package gazebo_ros that only has an empty_world.launch."""
    (tmp_path / "gazebo_ros/launch").mkdir(parents=True)
    (tmp_path / "gazebo_ros/package.xml").write_text("<package/>")
    (tmp_path / "gazebo_ros/launch/empty_world.launch").write_text(EMPTY_WORLD)
    return PackagePath([robots, tmp_path])


def test_every_launch_file_is_in_one_of_the_tables(launch):
    assert (launch.stem in FRAMES) != (launch.stem in WITH_A_WORLD)


@pytest.mark.parametrize("name", FRAMES)
def test_it_runs_and_brings_its_frames(robots, name):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        launched = sim.roslaunch("hello_ros", f"{name}.launch")
        sim.run(1.0)
        assert (launched.failures, launched.refusals) == ([], [])
        number = name.rpartition("_")[2]
        urdf = robots / f"hello_ros/urdf/hello_ros_robot_{number}.urdf"
        assert sim.params.get("/robot_description") == urdf.read_text()
        assert sorted(sim.tf.core.frame_strings) == FRAMES[name]
        if FRAMES[name]:
            drawn = sim.view_frames().to_svg()
            assert [frame for frame in FRAMES[name] if frame not in drawn] == []
            assert sim.view_frames().warnings == ()
            assert sim.rviz().problems == ()


def test_the_view_of_the_first_robot_stands_on_its_own_link(robots):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        sim.roslaunch("hello_ros", "urdf_launch_1.launch")
        sim.run(1.0)
        assert len(sim.rviz(fixed_frame="base_link").scene.solids) == 1


def test_sliders_move_the_arm(robots):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        launched = sim.roslaunch("hello_ros", "urdf_launch_3.launch")
        sim.run(0.5)
        sliders = launched.nodes["/joint_state_publisher"].program
        assert [joint.name for joint in sliders.joints] == ["hip", "shoulder"]
        sliders.set_position("hip", 1.5707963)
        sim.run(0.5)
        arm = sim.tf.lookup_transform("world", "upper_arm").transform.translation
        assert (arm.x, arm.y, arm.z) == pytest.approx((0.1, 0.0, 0.5), abs=1e-6)


MODELS = {
    "spawn_gazebo_1": ["ground_plane", "hello_ros_robot"],
    "spawn_gazebo_2": ["ground_plane", "hello_ros_robot"],
    "spawn_urdf": ["ground_plane", "m2wr"],
    "practice_world": ["ground_plane"],
}


@pytest.mark.parametrize("name", WITH_A_WORLD)
def test_it_starts_a_world_and_brings_its_robot(robots, name):
    (path,) = robots.glob(f"*/launch/{name}.launch")
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        launched = sim.roslaunch(path)
        sim.run(1.0)
        assert (launched.failures, launched.refusals) == ([], [])
        assert list(sim.gazebo.spawned) == MODELS[name]
        assert sim.now.to_sec() == 1.0  # a simulation that begins with a world begins at 0
        assert [line.text for line in sim.log if line.level > LogLevel.WARN] == []


def test_a_robot_comes_into_a_world_that_runs(robots):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        sim.run(1.0)
        sim.roslaunch("gazebo_ros", "empty_world.launch")
        launched = sim.roslaunch("my_robot_urdf", "spawn_urdf.launch", "world:=false")
        sim.run(1.0)
        assert launched.failures == []
        assert "m2wr" in sim.gazebo.spawned
        assert sim.now.to_sec() > 1.6e9  # it does not jump: this one began without a world


@pytest.mark.parametrize("name", WITH_A_WORLD)
def test_with_gazebo_ros_it_has_no_fault(robots, stand_in, name):
    (path,) = robots.glob(f"*/launch/{name}.launch")
    plan = evaluate(path, packages=stand_in, environment={})
    assert (plan.warnings, plan.diagnostics) == ((), ())
    assert [(node.package, node.type) for node in plan.nodes] == WITH_A_WORLD[name]
    assert plan.params["/use_sim_time"] is True


@pytest.mark.parametrize(
    ("launch_name", "urdf_name", "model"),
    [
        ("spawn_gazebo_1", "hello_gazebo_robot_1", "hello_ros_robot"),
        ("spawn_gazebo_2", "hello_gazebo_robot_2", "hello_ros_robot"),
        ("spawn_urdf", "m2wr", "m2wr"),
    ],
)
def test_it_spawns_the_robot_that_it_loads(robots, stand_in, launch_name, urdf_name, model):
    (path,) = robots.glob(f"*/launch/{launch_name}.launch")
    (urdf,) = robots.glob(f"*/urdf/{urdf_name}.urdf")
    plan = evaluate(path, packages=stand_in, environment={})
    assert plan.params["/robot_description"] == urdf.read_text()
    assert f"-model {model}" in plan.nodes[0].args
    assert {"-urdf", "-param"} <= set(plan.nodes[0].args.split())


def test_the_controller_is_of_a_type_that_ros_has(robots, stand_in):
    path = robots / "hello_ros/launch/spawn_gazebo_2.launch"
    plan = evaluate(path, packages=stand_in, environment={})
    spawner = next(node for node in plan.nodes if node.type == "spawner")
    assert spawner.args == "arm_controller"
    told = {name: value for name, value in plan.params.items() if "/arm_controller/" in name}
    assert told == {
        "/arm_controller/type": "position_controllers/JointTrajectoryController",
        "/arm_controller/joints": ["hip", "shoulder"],
    }


def test_the_world_is_there_and_has_ground_and_light(robots, stand_in):
    path = robots / "gazebo_car/launch/practice_world.launch"
    asked = evaluate(path, packages=stand_in, environment={}).params["/stand_in/world_name"]
    world = robots / "gazebo_car/worlds/practice.world"
    assert asked == str(world)
    document = parse_xml(world.read_bytes(), file=world.name)
    assert document.faults == ()
    assert (document.root.name, document.root.get("version")) == ("sdf", "1.4")
    includes = [one.child("uri").text for one in document.root.child("world").all("include")]
    assert includes == ["model://ground_plane", "model://sun"]
    above = re.findall(r"<!-- (\w+ ?\w*).*?-->\s*<include>\s*<uri>(\S+)</uri>", world.read_text())
    assert above == [("the ground", "model://ground_plane"), ("light from", "model://sun")]


def test_the_packages_work_in_another_place(robots, tmp_path):
    shutil.copytree(robots / "hello_ros", tmp_path / "a place" / "hello_ros")
    plan = evaluate(
        tmp_path / "a place/hello_ros/launch/urdf_launch_3.launch",
        packages=PackagePath([tmp_path / "a place"]),
        environment={},
    )
    assert "upper_arm" in plan.params["/robot_description"]
