"""Two who say where joints are, or nobody."""

from __future__ import annotations

from simkit.msgs import message_class

JOINTS = "sensor_msgs/JointState"


def states_of(names: str) -> str:
    return f"""<gazebo><plugin name="states" filename="libgazebo_ros_joint_state_publisher.so">
      <jointName>{names}</jointName></plugin></gazebo>"""


def start_state_publisher(watched) -> None:
    node = watched.graph.create_node("/robot_state_publisher")
    node.subscribe("/joint_states", message_class(JOINTS), lambda _: None)
    node.advertise("/tf", message_class("tf2_msgs/TFMessage"))


def test_two_publishers_are_named(watched):
    watched.car(more=states_of("left_joint, right_joint"))
    watched.run(0.3)
    assert watched.found() == []
    watched.graph.create_node("/joint_state_publisher").advertise(
        "/joint_states", message_class(JOINTS)
    )
    watched.run(0.5)
    (text,) = watched.found("CTL-W07")
    assert "/gazebo and /joint_state_publisher both publish /joint_states" in text


def test_a_node_that_publishes_alone_is_fine(watched):
    watched.car()
    watched.graph.create_node("/joint_state_publisher").advertise(
        "/joint_states", message_class(JOINTS)
    )
    watched.run(0.5)
    assert watched.found() == []


def test_joints_that_nobody_publishes_are_named_when_they_move(watched):
    start_state_publisher(watched)
    watched.car()
    watched.run(2.5)
    assert watched.found() == []
    watched.tell(0.5)
    watched.run(1.0)
    (text,) = watched.found("CTL-W06")
    assert "the joint 'left_joint' of car has moved by" in text
    assert "there is no transform from 'left'" in text
    assert "Without state: left_joint, right_joint" in text
    assert "<jointName>left_joint, right_joint</jointName>" in text


def test_joints_that_are_published_are_not(watched):
    start_state_publisher(watched)
    watched.car(more=states_of("left_joint, right_joint"))
    watched.tell(0.5)
    watched.run(3)
    assert watched.found() == []


def test_without_a_state_publisher_nobody_misses_them(watched):
    watched.car()
    watched.tell(0.5)
    watched.run(3)
    assert watched.found() == []


def test_what_check_urdf_has_warned_of_is_not_said_again(watched):
    start_state_publisher(watched)
    watched.car(more=states_of("left_joint"))
    watched.tell(0.5)
    watched.run(3)
    assert watched.found() == []
