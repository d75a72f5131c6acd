"""The drive of four wheels: it obeys like the one of two, but turns only as far as its wheels slip."""

from __future__ import annotations

import pytest

from simkit.geometry import roll_pitch_yaw
from simkit.graph import LogLevel
from simkit.physics import Mode
from tests.simkit.plugins.samples import ROVER, Sample, driven, tell, twist

SAMPLE = Sample(
    robot=ROVER,
    tags={
        "leftFrontJoint": "left_front_joint",
        "rightFrontJoint": "right_front_joint",
        "leftRearJoint": "left_rear_joint",
        "rightRearJoint": "right_rear_joint",
        "wheelSeparation": "0.4",
        "wheelDiameter": "0.2",
        "broadcastTF": "true",
    },
    rate_tag="updateRate",
    commands={"/cmd_vel": twist(0.4, 0.5)},
)

SKID = "libgazebo_ros_skid_steer_drive.so"
ODOMETRY = "nav_msgs/Odometry"
TF = "tf2_msgs/TFMessage"
JOINTS = ["left_front_joint", "left_rear_joint", "right_front_joint", "right_rear_joint"]


@pytest.fixture
def rover(stage):
    """Spawns a rover whose plugin says these tags."""

    def make(pose=(0.0, 0.0, 0.1, 0.0, 0.0, 0.0), *, spawning=None, **tags):
        return stage.spawn(
            driven(SKID, **tags), name="rover", pose=stage.at(*pose), **(spawning or {})
        )

    return make


def test_it_drives_straight(stage, rover):
    model = rover().model
    tell(stage, 0.5)
    stage.run(1.05)
    x, y, _ = model.pose.translation
    assert x == pytest.approx(0.5, abs=0.03)
    assert abs(y) < 0.005


def test_it_turns_left_and_slips_while_it_does(stage, rover):
    model = rover().model
    tell(stage, 0.0, 1.0)
    stage.run(1.05)
    turned = roll_pitch_yaw(model.pose.rotation)[2]
    assert 0.1 < turned < 0.95
    assert model.joint("left_front_joint").velocity == pytest.approx(-2.0, rel=0.01)


def test_wheels_of_one_side_are_told_the_same(stage, rover):
    model = rover().model
    assert [model.joint(name).mode for name in JOINTS] == [Mode.VELOCITY] * 4
    tell(stage, 0.3, 1.0)
    stage.run(0.06)
    speeds = [model.joint(name).command for name in JOINTS]
    assert speeds == pytest.approx([1.0, 1.0, 5.0, 5.0])


def test_its_torque_is_a_bound(stage, rover):
    model = rover(torque="0.001").model
    tell(stage, 1.0)
    stage.run(0.5)
    assert abs(model.pose.translation[0]) < 0.05
    assert all(model.joint(name).is_saturated for name in JOINTS)


def test_it_goes_on_after_the_last_command(stage, rover):
    model = rover().model
    tell(stage, 0.5)
    stage.run(1.0)
    x = model.pose.translation[0]
    stage.run(0.5)
    assert model.pose.translation[0] - x == pytest.approx(0.25, rel=0.03)


def test_it_reports_the_truth_at_51_and_101_ms(stage, rover):
    model = rover((1.0, 2.0, 0.1, 0.0, 0.0, 0.5)).model
    truth = {}
    now = stage.graph.executor
    stage.gazebo.world.after_step.append(lambda: truth.update({now.now_ns: model.pose}))
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, 0.5)
    stage.run(0.16)
    times = [message.header.stamp.to_nsec() for message in heard]
    assert times == [51_000_000, 101_000_000, 151_000_000]
    for message, time_ns in zip(heard, times, strict=True):
        pose = truth[time_ns]
        position, q = message.pose.pose.position, message.pose.pose.orientation
        assert (position.x, position.y) == pose.translation[:2]
        assert (q.x, q.y, q.z, q.w) == pose.rotation
        assert position.z == 0.0


def test_its_covariances_are_those_of_the_tag_for_pose_and_twist(stage, rover):
    rover(covariance_x="0.1", covariance_y="0.2", covariance_yaw="0.3")
    heard = stage.listen("/odom", ODOMETRY)
    stage.run(0.06)
    diagonal = [0.1, 0.2, 1e12, 1e12, 1e12, 0.3]
    for covariance in (heard[0].pose.covariance, heard[0].twist.covariance):
        assert [covariance[7 * i] for i in range(6)] == diagonal
        assert sum(map(bool, covariance)) == 6


def test_it_is_on_tf_only_if_asked_and_then_with_its_height(stage, rover):
    rover(broadcastTF="true", odometryFrame="map", robotBaseFrame="base")
    heard = stage.listen("/tf", TF)
    stage.run(0.06)
    (moved,) = heard[0].transforms
    assert (moved.header.frame_id, moved.child_frame_id) == ("map", "base")
    assert moved.transform.translation.z == pytest.approx(0.1, abs=1e-3)


def test_it_is_not_on_tf_if_not_asked(stage, rover):
    rover()
    heard = stage.listen("/tf", TF)
    stage.run(0.06)
    assert heard == []


def test_what_is_missing_is_told_with_its_default(stage):
    stage.spawn(f'{ROVER}<gazebo><plugin name="d" filename="{SKID}"/></gazebo>')
    speaker = "GazeboRosSkidSteerDrive Plugin (ns = //): missing "
    told = [said.removeprefix(speaker) for said in stage.said() if said.startswith(speaker)]
    assert len(told) == 16
    assert "<broadcastTF> default is false" in told
    assert "<wheelSeparation> default is 0.4" in told
    assert "<torque> default is 5" in told
    assert "<covariance_yaw> default is 0.01" in told


@pytest.mark.parametrize(
    "tag", ["leftFrontJoint", "rightFrontJoint", "leftRearJoint", "rightRearJoint"]
)
def test_a_joint_that_is_not_there_keeps_the_plugin_away(stage, rover, tag):
    spawned = rover(**{tag: "nowhere"})
    (complaint,) = stage.said(LogLevel.ERROR)
    assert "couldn't get wheel hinge joint named nowhere" in complaint
    assert f"<{tag}>" in complaint
    assert spawned.plugins == ()


def test_in_a_world_file_its_names_are_at_the_root(stage, rover):
    model = rover(spawning={"namespace": None}).model
    tell(stage, 0.5)
    stage.run(0.5)
    assert model.pose.translation[0] > 0.1


def test_a_prefix_of_frames_is_a_parameter_and_not_the_namespace(stage, rover):
    rover(spawning={"namespace": "/one"})
    heard = stage.listen("/one/odom", ODOMETRY)
    stage.run(0.06)
    assert heard[0].header.frame_id == "odom"


def test_a_reset_forgets_the_command(stage, rover):
    model = rover().model
    tell(stage, 0.5)
    stage.run(0.3)
    stage.gazebo.reset_world()
    stage.run(0.2)
    assert abs(model.pose.translation[0]) < 1e-4
    assert [model.joint(name).mode for name in JOINTS] == [Mode.VELOCITY] * 4
