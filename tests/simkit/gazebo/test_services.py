"""The services and topics below /gazebo."""

from __future__ import annotations

import pytest

from simkit.gazebo.services import GROUPS
from simkit.geometry import Transform
from simkit.msgs import Duration, message_class

BALL = """<robot name="ball"><link name="ball">
  <inertial><mass value="2"/><inertia ixx="0.004" iyy="0.004" izz="0.004" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""
WHEEL = """<robot name="wheel"><link name="world"/><link name="wheel">
  <inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
</link><joint name="axle" type="continuous"><parent link="world"/><child link="wheel"/>
  <origin xyz="0 0 1"/><axis xyz="0 0 1"/></joint></robot>"""


@pytest.fixture
def ball(gazebo):
    """A ball in the air."""
    pose = Transform((0.0, 0.0, 5.0))
    return gazebo.spawn_urdf(BALL, name="ball", pose=pose).model


@pytest.fixture
def axle(gazebo):
    """The joint of a wheel."""
    return gazebo.spawn_urdf(WHEEL, name="wheel").model.joint("axle")


def test_every_service_of_every_group_is_offered_by_gazebo(sim, gazebo):
    for group in GROUPS:
        assert group.marked()
        for (name, _), _ in group.marked():
            assert sim.graph.services[f"/gazebo/{name}"].node_name == "/gazebo"


def test_models_are_spawned_and_deleted(sim, gazebo):
    answer = sim.call("/gazebo/spawn_urdf_model", model_name="b", model_xml=BALL)
    assert (answer.success, answer.status_message) == (
        True,
        "SpawnModel: Successfully spawned entity",
    )
    assert gazebo.spawned["b"].namespace is None
    answer = sim.call("/gazebo/delete_model", model_name="b")
    assert answer.status_message == "DeleteModel: successfully deleted model"
    answer = sim.call("/gazebo/delete_model", model_name="b")
    assert not answer.success
    assert answer.status_message.startswith("DeleteModel: model [b] does not exist")
    assert not sim.call("/gazebo/spawn_sdf_model", model_name="b", model_xml="<sdf").success


def test_the_state_of_a_model_is_told_and_set(sim, gazebo, ball):
    state = message_class("gazebo_msgs/ModelState")(model_name="ball")
    state.pose.position.x, state.pose.position.z = 1.0, 3.0
    state.pose.orientation.w = 1.0
    state.twist.linear.x = 2.0
    gazebo.pause()
    assert sim.call("/gazebo/set_model_state", model_state=state).success
    told = sim.call("/gazebo/get_model_state", model_name="ball")
    assert (told.pose.position.x, told.pose.position.z, told.twist.linear.x) == (1.0, 3.0, 2.0)
    beside = sim.call(
        "/gazebo/get_model_state", model_name="ball", relative_entity_name="ground_plane"
    )
    assert beside.pose.position.x == 1.0
    assert (
        "here are: ground_plane, ball"
        in sim.call("/gazebo/get_model_state", model_name="bal").status_message
    )
    assert ball.twist[0] == (2.0, 0.0, 0.0)


def test_the_state_of_a_link_is_told_by_long_and_by_short_name(sim, ball):
    for name in ("ball::ball", "ball"):
        told = sim.call("/gazebo/get_link_state", link_name=name)
        assert told.success
        assert told.link_state.pose.position.z == ball.link_pose("ball").translation[2]
    assert not sim.call("/gazebo/get_link_state", link_name="bell").success
    assert sim.call("/gazebo/get_link_properties", link_name="ball::ball").mass == 2.0


def test_a_link_that_carries_its_model_is_set_and_others_are_refused(sim, gazebo, ball, axle):
    gazebo.pause()
    state = message_class("gazebo_msgs/LinkState")(link_name="ball::ball")
    state.pose.position.x, state.pose.orientation.w, state.twist.angular.z = 4.0, 1.0, 2.0
    assert sim.call("/gazebo/set_link_state", link_state=state).success
    assert ball.pose.translation == pytest.approx((4.0, 0.0, 0.0))
    assert ball.twist[1] == (0.0, 0.0, 2.0)
    two = BALL.replace("</robot>", "").replace('name="ball"', 'name="arm"') + (
        '<link name="tip"><inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" '
        'ixy="0" ixz="0" iyz="0"/></inertial></link><joint name="j" type="continuous">'
        '<parent link="arm"/><child link="tip"/><axis xyz="0 0 1"/></joint></robot>'
    )
    gazebo.spawn_urdf(two, name="arm")
    state.link_name = "arm::tip"
    refused = sim.call("/gazebo/set_link_state", link_state=state)
    assert not refused.success
    assert "tip hangs on joints" in refused.status_message
    assert axle.position == 0.0


def test_joints_are_told_set_and_driven(sim, gazebo, axle):
    answer = sim.call(
        "/gazebo/set_model_configuration",
        model_name="wheel",
        joint_names=["axle"],
        joint_positions=[0.75],
    )
    assert answer.success
    told = sim.call("/gazebo/get_joint_properties", joint_name="axle")
    assert (told.type, list(told.position)) == (told.CONTINUOUS, [0.75])
    sim.call("/gazebo/apply_joint_effort", joint_name="axle", effort=0.2, duration=Duration(1))
    sim.run(2.0)
    assert axle.velocity == pytest.approx(0.2 / 0.1 * 1.0, rel=2e-3)  # for 1 s, then no more
    assert gazebo.world.before_step == []
    lengths = sim.call(
        "/gazebo/set_model_configuration",
        model_name="wheel",
        joint_names=["axle"],
        joint_positions=[],
    )
    assert "different lengths: 1 and 0" in lengths.status_message


def test_a_wrench_pushes_for_its_time(sim, ball):
    wrench = message_class("geometry_msgs/Wrench")()
    wrench.force.x, wrench.force.z = 4.0, 2 * 9.8
    sim.call(
        "/gazebo/apply_body_wrench",
        body_name="ball::ball",
        wrench=wrench,
        duration=Duration(0, 500_000_000),
    )
    sim.run(0.5)
    assert ball.twist[0][0] == pytest.approx(4.0 / 2.0 * 0.5, rel=1e-2)
    assert ball.twist[0][2] == pytest.approx(0.0, abs=0.02)
    sim.run(0.3)
    assert ball.twist[0][0] == pytest.approx(1.0, rel=1e-2)
    assert ball.twist[0][2] < -2.5


def test_a_push_without_end_ends_when_it_is_cleared(sim, gazebo, ball):
    wrench = message_class("geometry_msgs/Wrench")()
    wrench.force.z = 2 * 9.8
    sim.call("/gazebo/apply_body_wrench", body_name="ball", wrench=wrench, duration=Duration(-1))
    sim.run(1.0)
    assert ball.pose.translation[2] == pytest.approx(5.0, abs=0.02)
    sim.call("/gazebo/clear_body_wrenches", body_name="ball")
    sim.run(0.1)
    assert ball.twist[0][2] < -0.9


def test_time_and_gravity_are_told_and_set(sim, gazebo, ball):
    sim.call("/gazebo/pause_physics")
    told = sim.call("/gazebo/get_physics_properties")
    assert (told.time_step, told.pause, told.gravity.z) == (0.001, True, -9.8)
    gravity = message_class("geometry_msgs/Vector3")(z=-1.62)
    assert sim.call("/gazebo/set_physics_properties", time_step=0.001, gravity=gravity).success
    assert gazebo.world.gravity == (0.0, 0.0, -1.62)
    refused = sim.call("/gazebo/set_physics_properties", time_step=0.01, gravity=gravity)
    assert "max_step_size" in refused.status_message
    sim.call("/gazebo/unpause_physics")
    sim.run(0.5)
    assert sim.call("/gazebo/get_world_properties").model_names == ["ground_plane", "ball"]
    sim.call("/gazebo/reset_world")
    assert ball.pose.translation[2] == pytest.approx(5.0, abs=1e-4)
    sim.call("/gazebo/reset_simulation")
    assert sim.call("/gazebo/get_world_properties").sim_time < 0.01


def test_states_are_published_each_step_while_somebody_listens(sim, gazebo, ball):
    recording = sim.record(["/gazebo/model_states", "/gazebo/link_states", "/clock"])
    sim.run(0.01)
    for topic in recording.topics():
        assert len(recording[topic]) == 10
    names = recording["/gazebo/model_states"][-1][1].name
    assert names == ["ground_plane", "ball"]
    assert recording["/gazebo/link_states"][-1][1].name == ["ground_plane::link", "ball::ball"]
    recording.stop()
    sim.run(0.01)
    assert gazebo.world.after_step == []


def test_a_model_is_set_by_a_topic(sim, ball):
    sim.rostopic_pub(
        "/gazebo/set_model_state",
        "gazebo_msgs/ModelState",
        "{model_name: ball, pose: {position: {x: 3.0, z: 1.0}, orientation: {w: 1.0}}}",
    )
    sim.run(0.01)
    assert ball.pose.translation[0] == 3.0
