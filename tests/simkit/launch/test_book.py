"""The launch files of the book's exercises, with its names and numbers, and one for exercise 3.3."""

import pytest

from simkit.launch import LaunchError, evaluate
from simkit.packages import PackagePath

ROBOT = """\
<?xml version="1.0"?>
<robot name="hello_ros_robot">
  <link name="world"/>
  <link name="base_link"/>
  <joint name="fixed" type="fixed">
    <parent link="world"/>
    <child link="base_link"/>
  </joint>
</robot>
"""
URDF_LAUNCH_1 = """\
<launch>
  <param name="robot_description" textfile="$(find
hello_ros)/urdf/hello_ros_robot_1.urdf" />
</launch>
"""
URDF_LAUNCH_2 = """\
<launch>
  <param name="robot_description" textfile="$(find
hello_ros)/urdf/hello_ros_robot_2.urdf" />
  <param name="use_gui" value="true" />
  <node name="joint_state_publisher" pkg="joint_state_publisher"
    type="joint_state_publisher"/>
  <node name="robot_state_publisher" pkg="robot_state_publisher"
    type="robot_state_publisher"/>
</launch>
"""
URDF_LAUNCH_3 = URDF_LAUNCH_2.replace("robot_2.urdf", "robot_3.urdf")
SPAWN_URDF = """\
<?xml version="1.0" encoding="UTF-8"?>
<launch>
  <param name="robot_description" command="cat '$(find hello_ros)/urdf/m2wr.urdf'" />
  <node name="mybot_spawn" pkg="gazebo_ros" type="spawn_model" output="screen"
    args="-urdf -param robot_description -model m2wr" />
</launch>
"""
SPAWN_GAZEBO_2 = """\
<launch>
  <include file="$(find gazebo_ros)/launch/empty_world.launch"/>
  <node name="spawn_urdf" pkg="gazebo_ros" type="spawn_model"
    args="-param robot_description -urdf -model hello_ros_robot" />
  <rosparam file="$(find hello_ros)/urdf/controllers_simple.yaml">
command="load"/>
<node name="controller_spawner" pkg="controller_manager"
type="spawner"
args="arm_controller"/>
</launch>
"""
START_TURTLES = """\
<launch>
  <node name="turtlesim" pkg="turtlesim" type="turtlesim_node"/>
  <node name="turtle1_tf_broadcaster" pkg="hello_ros" type="turtle_tf_broadcaster.py"
        args="_turtle:=turtle1"/>
  <node name="turtle2_tf_broadcaster" pkg="hello_ros" type="turtle_tf_broadcaster.py"
        args="_turtle:=turtle2"/>
  <node name="listener" pkg="hello_ros" type="turtle_tf_listener.py" output="screen"/>
</launch>
"""


@pytest.fixture
def hello_ros(tmp_path):
    """Writes launch files into the package `hello_ros`, and evaluates them."""
    folder = tmp_path / "hello_ros"
    for name in ("launch", "urdf"):
        (folder / name).mkdir(parents=True)
    (folder / "package.xml").write_text("<package/>")
    for name in ("hello_ros_robot_1", "hello_ros_robot_2", "hello_ros_robot_3", "m2wr"):
        (folder / f"urdf/{name}.urdf").write_text(ROBOT.replace("hello_ros_robot", name))

    def evaluated(name, text):
        path = folder / "launch" / name
        path.write_text(text)
        return evaluate(path, packages=PackagePath([tmp_path]), environment={})

    return evaluated


def test_the_first_only_loads_the_robot(hello_ros):
    found = hello_ros("urdf_launch_1.launch", URDF_LAUNCH_1)
    assert found.params == {
        "/robot_description": ROBOT.replace("hello_ros_robot", "hello_ros_robot_1")
    }
    assert (found.nodes, found.warnings, found.diagnostics) == ((), (), ())
    assert found.shown_file == "hello_ros/launch/urdf_launch_1.launch"


@pytest.mark.parametrize(("number", "text"), [(2, URDF_LAUNCH_2), (3, URDF_LAUNCH_3)])
def test_the_others_start_the_publishers_with_sliders(hello_ros, number, text):
    found = hello_ros(f"urdf_launch_{number}.launch", text)
    assert list(found.params) == ["/robot_description", "/use_gui"]
    assert f'name="hello_ros_robot_{number}"' in found.params["/robot_description"]
    assert found.params["/use_gui"] is True
    assert [(one.resolved_name, one.package, one.type) for one in found.nodes] == [
        ("/joint_state_publisher", "joint_state_publisher", "joint_state_publisher"),
        ("/robot_state_publisher", "robot_state_publisher", "robot_state_publisher"),
    ]
    assert found.warnings == ()
    (told,) = found.diagnostics
    assert (told.rule, told.severity.value) == ("LCH-W05", "note")
    assert "joint_state_publisher_gui" in told.remedy


def test_the_robot_of_another_course_is_read_by_cat(hello_ros):
    found = hello_ros("spawn_urdf.launch", SPAWN_URDF)
    assert found.params == {"/robot_description": ROBOT.replace("hello_ros_robot", "m2wr")}
    (node,) = found.nodes
    assert (node.package, node.type, node.output) == ("gazebo_ros", "spawn_model", "screen")
    assert node.args == "-urdf -param robot_description -model m2wr"


def test_the_fault_of_the_books_last_one_is_named_at_its_place(hello_ros):
    with pytest.raises(LaunchError) as caught:
        hello_ros("spawn_gazebo_2.launch", SPAWN_GAZEBO_2)
    error = caught.value
    assert (
        error.said == "RLException: Invalid roslaunch XML syntax: mismatched tag: line 10, column 2"
    )
    assert error.line == 5  # the tag that was closed too early
    assert error.diagnostic.rule == "LCH-E04"


def test_the_turtles_of_exercise_3_3(hello_ros):
    found = hello_ros("start_turtles.launch", START_TURTLES)
    assert [(one.name, one.args, one.output) for one in found.nodes] == [
        ("turtlesim", "", "log"),
        ("turtle1_tf_broadcaster", "_turtle:=turtle1", "log"),
        ("turtle2_tf_broadcaster", "_turtle:=turtle2", "log"),
        ("listener", "", "screen"),
    ]
