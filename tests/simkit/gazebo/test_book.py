"""The launch files, the YAML, the world and the command lines of the book, as it has them, with robots without its slips."""

from __future__ import annotations

from pathlib import Path

import pytest

from simkit import Simulation
from simkit.graph import LogLevel
from simkit.launch import LaunchError

ROBOTS = Path(__file__).resolve().parents[3] / "robots"
SPAWN_GAZEBO_1 = """\
<launch>
    <param name="robot_description" textfile="$(find
hello_ros)/urdf/hello_gazebo_robot_1.urdf" />
    <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
    <node name="spawn_urdf" pkg="gazebo_ros" type="spawn_model"
        args="-param robot_description -urdf -model hello_ros_robot" />
</launch>
"""
SPAWN_GAZEBO_2 = """\
<launch>
  <param name="robot_description" textfile="$(find
hello_ros)/urdf/hello_gazebo_robot_2.urdf" />
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <node name="spawn_urdf" pkg="gazebo_ros" type="spawn_model"
    args="-param robot_description -urdf -model hello_ros_robot" />
  <rosparam file="$(find hello_ros)/urdf/controllers_simple.yaml"
command="load"/>
<node name="controller_spawner" pkg="controller_manager"
type="spawner"
args="arm_controller"/>
<node name="robot_state_publisher" pkg="robot_state_publisher"
type="robot_state_publisher"/>
</launch>
"""
CONTROLLERS = """\
arm_controller:
  type: "position_controllers/JointTrajectoryController"
  joints:
    - hip
    - shoulder
"""
SPAWN_URDF = """\
<?xml version="1.0" encoding="UTF-8"?>
<launch>
  <param name="robot_description" command="cat '$(find my_robot_urdf)/urdf/m2wr.urdf'" />
  <node name="mybot_spawn" pkg="gazebo_ros" type="spawn_model" output="screen"
    args="-urdf -param robot_description -model m2wr" />
</launch>
"""
WORLD = """\
<?xml version="1.0" ?> <sdf version="1.4"> <world name="default">
<include> <uri>model://ground_plane</uri> </include>
<include> <uri>model://sun</uri> </include>
</world> </sdf>
"""
WORLD_LAUNCH = """\
<launch> <include file="$(find gazebo_ros)/launch/empty_world.launch">
<arg name="world_name" value="$(find gazebo_car)/worlds/{}"/> </include> </launch>
"""


@pytest.fixture
def packages(tmp_path):
    """The packages of the book, with our robots and its other files."""
    files = {
        "hello_ros/launch/spawn_gazebo_1.launch": SPAWN_GAZEBO_1,
        "hello_ros/launch/spawn_gazebo_2.launch": SPAWN_GAZEBO_2,
        "hello_ros/launch/with_a_slip.launch": SPAWN_GAZEBO_2.replace('.yaml"\n', '.yaml">\n'),
        "hello_ros/urdf/controllers_simple.yaml": CONTROLLERS,
        "my_robot_urdf/launch/spawn_urdf.launch": SPAWN_URDF,
        "gazebo_car/worlds/mine.world": WORLD,
        "gazebo_car/launch/mine.launch": WORLD_LAUNCH.format("mine.world"),
        "gazebo_car/launch/with_a_slip.launch": WORLD_LAUNCH.format("mine"),
    }
    for robot in ROBOTS.glob("*/urdf/*.urdf"):
        files[str(robot.relative_to(ROBOTS))] = robot.read_text()
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        (tmp_path / name.split("/")[0] / "package.xml").write_text("<package/>")
    return tmp_path


@pytest.fixture
def sim(packages):
    """A simulation that finds them."""
    with Simulation(package_path=[packages], screen=None) as made:
        yield made


def errors(sim):
    return [record.text for record in sim.log if record.level >= LogLevel.ERROR]


def test_3_9_the_arm_is_a_numb_pendulum(sim):
    launched = sim.roslaunch("hello_ros", "spawn_gazebo_1.launch")
    sim.run(1.0)
    assert (launched.failures, errors(sim)) == ([], [])
    arm = sim.world.model("hello_ros_robot")
    positions = [arm.joint(name).position for name in ("hip", "shoulder")]
    # Its numbers by an independent integration; the robot comes in 0 s after the clock began.
    assert positions == pytest.approx([0.027825, 0.414187], abs=0.01)


def test_3_10_the_command_line_of_the_book_moves_the_arm(sim):
    sim.roslaunch("hello_ros", "spawn_gazebo_2.launch")
    sim.run(1.0)
    arm = sim.world.model("hello_ros_robot")
    assert [joint.position for joint in arm.joints.values()] == [0.0, 0.0]
    sim.rosrun(
        "rostopic",
        "rostopic",
        "pub",
        "/arm_controller/command",
        "trajectory_msgs/JointTrajectory",
        '{joint_names: ["hip", "shoulder"], points: [{positions: [0.1, -0.5],  \n'
        "time_from_start:[1.0,0.0]}]}",
    )
    sim.run(0.5)
    halfway = [arm.joint(name).position for name in ("hip", "shoulder")]
    assert halfway == pytest.approx([0.05, -0.25], abs=2e-3)
    sim.run(1.0)
    assert [arm.joint(name).position for name in ("hip", "shoulder")] == [0.1, -0.5]
    assert errors(sim) == []
    tip = sim.tf.lookup_transform("world", "upper_arm").transform.translation
    assert tip.z == pytest.approx(0.5, abs=1e-6)


def test_3_10_its_slip_in_the_launch_file_is_named(sim):
    with pytest.raises(LaunchError, match="mismatched tag") as caught:
        sim.roslaunch("hello_ros", "with_a_slip.launch")
    assert "Delete this >" in str(caught.value)


def test_s_1_the_robot_comes_into_a_world_that_runs(sim):
    sim.roslaunch("gazebo_ros", "empty_world.launch")
    launched = sim.roslaunch("my_robot_urdf", "spawn_urdf.launch")
    sim.run(1.0)
    assert (launched.failures, errors(sim)) == ([], [])
    assert any("Spawn it with -z 0.10" in record.text for record in sim.log)
    sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.5}}")
    sim.run(1.0)
    assert sim.latest("/odom").pose.pose.position.x > 0.4


def test_s_2_the_world_is_there_and_the_car_falls_into_it(sim, packages):
    sim.roslaunch("gazebo_car", "mine.launch")
    sim.rosrun(
        *("gazebo_ros", "spawn_model", "-file", f"{packages}/gazebo_car/urdf/practice_car.urdf"),
        *("-urdf", "-x", "0", "-y", "0", "-z", "1", "-model", "practice_car"),
    )
    sim.run(0.4)
    car = sim.world.model("practice_car")
    assert car.twist[0][2] == pytest.approx(-9.8 * 0.4, rel=0.01)
    sim.run(2.0)
    assert car.pose.translation == pytest.approx((0.0, 0.0, 0.0), abs=1e-3)
    assert errors(sim) == []


def test_s_2_the_name_without_its_ending_is_named(sim):
    launched = sim.roslaunch("gazebo_car", "with_a_slip.launch")
    assert "mine.world is there: the name needs its ending .world" in launched.failures[0]
