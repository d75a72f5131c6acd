"""Launch files: those that need no simulated world run, the others are without a fault but for what is not there yet."""

from __future__ import annotations

import re
import shutil

import pytest

from simkit import Simulation
from simkit.diagnostics import Severity
from simkit.graph import LogLevel
from simkit.launch import evaluate
from simkit.packages import PackagePath
from simkit.urdf import load_robot
from simkit.xml import parse_xml
from tests.laws import broken_laws

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


def has_world(launch):
    return "gazebo_ros" in launch.read_text()


def robots_named_in(launch):
    """The robots of the folder whose files a launch file names."""
    text = launch.read_text()
    return [path for path in sorted(launch.parents[2].glob("*/urdf/*.urdf")) if path.name in text]


def models_of(plan):
    """Names in the world of the models that a launch file spawns."""
    spawners = [node.args.split() for node in plan.nodes if node.type == "spawn_model"]
    return [words[words.index("-model") + 1] for words in spawners]


def test_it_runs_and_brings_its_robot_and_its_frames(launch, robots):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        launched = sim.roslaunch(launch)
        sim.run(1.0)
        assert (launched.failures, launched.refusals) == ([], [])
        assert [line.text for line in sim.log if line.level > LogLevel.WARN] == []
        for urdf in robots_named_in(launch):
            text = urdf.read_text()
            assert sim.params.get("/robot_description") == text
            if "/robot_state_publisher" in sim.nodes():
                expect_frames(sim, load_robot(text, file=urdf.name))
        if has_world(launch):
            assert list(sim.gazebo.spawned) == ["ground_plane", *models_of(sim.launch_plan(launch))]
            assert sim.now.to_sec() == 1.0  # a simulation that begins with a world begins at 0


def expect_frames(sim, robot):
    links = set(robot.links)
    assert links <= set(sim.tf.core.frame_strings)
    drawn = sim.view_frames()
    assert [link for link in links if link not in drawn.to_svg()] == []
    assert drawn.warnings == ()
    assert sim.rviz(fixed_frame=robot.root).problems == ()


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


def test_a_robot_comes_into_a_world_that_runs(robots):
    with Simulation(seed=1, package_path=[robots], screen=None) as sim:
        sim.run(1.0)
        sim.roslaunch("gazebo_ros", "empty_world.launch")
        launched = sim.roslaunch("my_robot_urdf", "spawn_urdf.launch", "world:=false")
        sim.run(1.0)
        assert launched.failures == []
        assert "m2wr" in sim.gazebo.spawned
        assert sim.now.to_sec() > 1.6e9  # it does not jump: this one began without a world


def test_with_gazebo_ros_it_has_no_fault_and_spawns_what_it_loads(launch, stand_in):
    plan = evaluate(launch, packages=stand_in, environment={})
    assert plan.warnings == ()
    worse = [one for one in plan.diagnostics if one.severity is not Severity.NOTE]
    broken_laws(worse, f"correct {launch.name}")
    assert plan.params.get("/use_sim_time", False) is has_world(launch)
    for node in plan.nodes:
        if node.type == "spawn_model":
            assert {"-urdf", "-param", "-model"} <= set(node.args.split())
            assert "robot_description" in node.args


def test_the_controller_is_of_a_type_that_ros_has(robots, stand_in):
    path = robots / "hello_ros/launch/spawn_gazebo_2.launch"
    plan = evaluate(path, packages=stand_in, environment={})
    spawner = next(node for node in plan.nodes if node.type == "spawner")
    assert spawner.args == "arm_controller"
    given = {name: value for name, value in plan.params.items() if "/arm_controller/" in name}
    assert given == {
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
