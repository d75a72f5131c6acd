"""The differential drive: it moves as commanded, and says how it moved."""

from __future__ import annotations

import itertools
import math
from pathlib import Path

import pytest

from simkit.geometry import roll_pitch_yaw
from simkit.graph import LogLevel
from simkit.msgs import message_class
from simkit.physics import Mode
from simkit.plugins.odometry import EncoderOdometry
from tests.simkit.plugins.samples import CAR, CASTER, Sample, driven, link, tell, twist, wheel

SAMPLE = Sample(
    robot=CAR,
    tags={
        "leftJoint": "left_joint",
        "rightJoint": "right_joint",
        "wheelSeparation": "0.4",
        "wheelDiameter": "0.2",
        "wheelAcceleration": "1",
        "odometrySource": "encoder",
        "publishWheelTF": "true",
        "publishWheelJointState": "true",
    },
    rate_tag="updateRate",
    commands={"/cmd_vel": twist(0.4, 0.5)},
)

M2WR = Path(__file__).parents[3] / "robots/my_robot_urdf/urdf/m2wr.urdf"
ODOMETRY = "nav_msgs/Odometry"
TF = "tf2_msgs/TFMessage"
MS = 1_000_000


def car(stage, pose=(0.0, 0.0, 0.1, 0.0, 0.0, 0.0), *, robot="", spawning=None, **tags):
    """Spawn a car whose plugin says these tags."""
    text = driven(robot=robot, **tags)
    return stage.spawn(text, name="car", pose=stage.at(*pose), **(spawning or {}))


def yaw_of(placement) -> float:
    return roll_pitch_yaw(placement.rotation)[2]


def stamps(messages) -> list[int]:
    return [message.header.stamp.to_nsec() // MS for message in messages]


# -- driving


def test_the_mended_robot_drives_five_metres_straight(stage):
    robot = stage.gazebo.spawn_urdf(
        M2WR.read_text(), name="m2wr", pose=stage.at(z=0.1), file="m2wr.urdf"
    )
    stage.run(0.2)
    tell(stage, 1.0)
    while robot.model.pose.translation[0] < 5.0 and stage.graph.executor.now_ns < 8e9:
        stage.run(0.05)
    x, y, z = robot.model.pose.translation
    assert x >= 5.0
    assert abs(y) < 0.005
    assert z == pytest.approx(0.1, abs=1e-3)
    assert abs(math.degrees(yaw_of(robot.model.pose))) < 0.2
    assert robot.model.twist[0][0] == pytest.approx(1.0, rel=0.01)


@pytest.mark.parametrize("angular", [1.0, -0.5])
def test_the_mended_robot_turns_as_fast_as_it_is_told(stage, angular):
    robot = stage.gazebo.spawn_urdf(
        M2WR.read_text(), name="m2wr", pose=stage.at(z=0.1), file="m2wr.urdf"
    )
    stage.run(0.1)
    tell(stage, 0.0, angular)
    stage.run(1.0)
    begin, seconds = yaw_of(robot.model.pose), 2.0
    stage.run(seconds)
    turned = yaw_of(robot.model.pose) - begin
    assert turned / seconds == pytest.approx(angular, rel=0.005)


def test_a_car_on_a_circle_comes_back(stage):
    model = car(stage).model
    tell(stage, 1.0, 2.0)
    stage.run(0.5)
    x, y, _ = model.pose.translation
    stage.run(math.pi)
    assert model.pose.translation[:2] == pytest.approx((x, y), abs=0.05)


BALL = '<sphere radius="0.1"/>'
WRONG = "\n".join(
    [
        link("base", '<box size="0.5 0.26 0.07"/>', mass=5.0, moment=0.1, extra=CASTER),
        wheel("left", 0.0, -0.15, BALL),
        wheel("right", 0.0, 0.15, BALL),
        '<gazebo reference="base"><mu1>0</mu1><mu2>0</mu2></gazebo>',
    ]
)
"""What is wrong with the robot of the book: left is right, and the hubs are 0.30 m apart, not 0.4."""


@pytest.mark.parametrize("angular", [0.5, -0.8])
def test_the_robot_of_the_book_turns_the_other_way_and_too_fast(stage, angular):
    model = car(stage, robot=WRONG).model
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, 0.0, angular)
    stage.run(1.0)
    begin = yaw_of(model.pose)
    stage.run(1.0)
    assert yaw_of(model.pose) - begin == pytest.approx(-angular * 0.4 / 0.3, rel=0.02)
    assert heard[-1].twist.twist.angular.z == pytest.approx(-angular * 0.4 / 0.3, rel=0.02)


def test_encoders_of_the_robot_of_the_book_believe_in_what_was_commanded(stage):
    car(stage, robot=WRONG, odometrySource="encoder")
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, 0.0, 0.5)
    stage.run(1.0)
    assert heard[-1].twist.twist.angular.z == pytest.approx(0.5, rel=0.01)


DRAGGING = CAR.replace("<mu1>0</mu1><mu2>0</mu2>", "")


def test_a_torque_that_is_too_small_moves_nothing(stage):
    spawned = car(stage, robot=DRAGGING, wheelTorque="0.1")
    tell(stage, 0.5)
    stage.run(1.0)
    assert abs(spawned.model.pose.translation[0]) < 1e-3
    assert spawned.model.joint("left_joint").is_saturated


def test_the_same_robot_moves_with_the_torque_that_is_the_default(stage):
    model = car(stage, robot=DRAGGING).model
    tell(stage, 0.5)
    stage.run(1.0)
    assert model.pose.translation[0] > 0.3


def test_torque_is_another_word_which_it_does_not_read(stage):
    driven = car(stage, torque="0.1")
    assert driven.plugins[0].parameters.wheel_torque == 5.0
    assert any("reads no parameter <torque>" in s for s in stage.said())  # so says check_urdf


def test_the_effort_limit_of_the_joint_does_not_bind_its_motor(stage):
    weak = DRAGGING.replace("</joint>", '<limit effort="0.001" velocity="0.001"/></joint>')
    model = car(stage, robot=weak).model
    tell(stage, 0.5)
    stage.run(1.0)
    assert model.pose.translation[0] > 0.3


def test_the_wheels_go_on_turning_after_the_last_command(stage):
    model = car(stage).model
    tell(stage, 0.5)
    stage.run(1.0)
    x = model.pose.translation[0]
    stage.run(1.0)
    assert model.pose.translation[0] - x == pytest.approx(0.5, rel=0.01)


def test_wheels_are_held_before_the_first_command(stage):
    model = car(stage, pose=(0.0, 0.0, 0.1, 0.0, 0.15, 0.0)).model
    stage.run(0.1)
    assert [joint.mode for joint in model.joints.values()] == [Mode.VELOCITY] * 2
    assert all(abs(joint.velocity) < 1e-6 for joint in model.joints.values())


def test_a_command_is_obeyed_when_it_is_time_and_the_last_one_counts(stage):
    model = car(stage).model
    stage.run(0.055)
    tell(stage, -1.0)
    tell(stage, 0.5)
    stage.run(0.045)
    assert model.joint("left_joint").command == 0.0
    stage.run(0.002)
    assert model.joint("left_joint").command == pytest.approx(5.0)


def test_speeds_of_the_wheels_are_those_of_their_rims(stage):
    model = car(stage).model
    tell(stage, 0.3, 1.0)
    stage.run(0.06)
    assert model.joint("left_joint").command == pytest.approx((0.3 - 0.2) / 0.1)
    assert model.joint("right_joint").command == pytest.approx((0.3 + 0.2) / 0.1)


def test_an_acceleration_is_not_exceeded(stage):
    model = car(stage, wheelAcceleration="0.5").model
    tell(stage, 1.0)
    speeds = []
    for _ in range(30):
        stage.run(0.05)
        speeds.append(model.twist[0][0])
    gains = [after - before for before, after in itertools.pairwise(speeds)]
    assert max(gains) < 0.5 * 0.051 * 1.2
    assert speeds[-1] == pytest.approx(0.5 * 0.051 * 29, rel=0.1)


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_a_command_that_is_no_number_is_not_obeyed(stage, number):
    model = car(stage).model
    tell(stage, 0.5)
    stage.run(0.06)
    tell(stage, number)
    stage.run(0.1)
    assert model.joint("left_joint").command == pytest.approx(5.0)
    assert any("NaN or infinity" in said for said in stage.said())


def test_a_command_beyond_all_bounds_does_no_harm(stage):
    model = car(stage).model
    tell(stage, 1e300, -1e300)
    stage.run(0.3)
    assert "car" in stage.gazebo.world.models
    assert all(math.isfinite(number) for number in model.pose.translation)


# -- reporting


def test_it_reports_at_51_101_and_151_ms(stage):
    stage.run(0.0371)
    begin = stage.gazebo.world.time_ns // MS
    car(stage)
    heard = stage.listen("/odom", ODOMETRY)
    stage.run(0.2)
    assert [stamp - begin for stamp in stamps(heard)] == [51, 101, 151]


def test_at_a_rate_of_zero_it_reports_each_step(stage):
    car(stage, updateRate="0")
    heard = stage.listen("/odom", ODOMETRY)
    stage.run(0.0105)
    assert stamps(heard) == list(range(1, 11))


def test_a_report_is_heard_at_the_time_of_its_stamp(stage):
    car(stage)
    lags = []

    def hear(message):
        lags.append(stage.graph.executor.now_ns - message.header.stamp.to_nsec())

    stage.listener.subscribe("/odom", message_class(ODOMETRY), hear)
    stage.run(0.2)
    assert lags == [0, 0, 0]


def test_odometry_of_the_world_is_the_pose_of_the_model(stage):
    model = car(stage, pose=(1.0, -2.0, 0.1, 0.0, 0.0, 0.7)).model
    truth = {}
    stage.gazebo.world.after_step.append(
        lambda: truth.update({stage.graph.executor.now_ns: (model.pose, model.twist)})
    )
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, -0.5, 0.6)
    stage.run(0.5)
    assert len(heard) == 9
    for message in heard:
        pose, (linear, angular) = truth[message.header.stamp.to_nsec()]
        position, q = message.pose.pose.position, message.pose.pose.orientation
        assert (position.x, position.y, position.z) == pose.translation
        assert (q.x, q.y, q.z, q.w) == pose.rotation
        yaw, twist = yaw_of(pose), message.twist.twist
        forward = math.cos(yaw) * linear[0] + math.sin(yaw) * linear[1]
        left = math.cos(yaw) * linear[1] - math.sin(yaw) * linear[0]
        assert (twist.linear.x, twist.linear.y) == pytest.approx((forward, left))
        assert twist.angular.z == angular[2]
    assert heard[-1].twist.twist.linear.x == pytest.approx(-0.5, rel=0.02)


def test_odometry_of_encoders_is_the_formula_on_what_the_wheels_turned(stage):
    model = car(stage, pose=(1.0, 2.0, 0.1, 0.0, 0.0, 1.0), odometrySource="encoder").model
    wheels = [model.joint("left_joint"), model.joint("right_joint")]
    formula, last, expected = EncoderOdometry(0.4), [0.0, 0.0], {}

    def follow():
        turned = [wheel.position for wheel in wheels]
        left, right = ((now - was) * 0.1 for now, was in zip(turned, last, strict=True))
        formula.advance(left, right, 1e-3)
        last[:] = turned
        expected[stage.graph.executor.now_ns] = formula.motion

    stage.gazebo.world.after_step.append(follow)
    heard = stage.listen("/odom", ODOMETRY)
    for linear, angular in ((0.5, 1.0), (-0.3, 0.5), (0.0, -2.0)):
        tell(stage, linear, angular)
        stage.run(0.4)
    assert len(heard) == 23
    for message in heard:
        motion = expected[message.header.stamp.to_nsec()]
        position, q = message.pose.pose.position, message.pose.pose.orientation
        twist = message.twist.twist
        assert (position.x, position.y) == pytest.approx(motion.pose.translation[:2], abs=1e-9)
        assert (q.z, q.w) == pytest.approx(motion.pose.rotation[2:], abs=1e-9)
        assert (twist.linear.x, twist.angular.z) == pytest.approx(
            (motion.linear[0], motion.turning), abs=1e-6
        )
        assert (position.z, twist.linear.y) == (0.0, 0.0)


def test_encoders_are_near_the_truth_on_a_robot_that_does_not_slip(stage):
    model = car(stage, odometrySource="encoder").model
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, 0.4, 0.5)
    stage.run(2.052)
    position = heard[-1].pose.pose.position
    assert (position.x, position.y) == pytest.approx(model.pose.translation[:2], abs=0.02)


def test_a_source_of_odometry_that_does_not_exist_is_the_world(stage):
    model = car(stage, pose=(1.0, 0.0, 0.1, 0.0, 0.0, 0.0), odometrySource="gps").model
    heard = stage.listen("/odom", ODOMETRY)
    stage.run(0.06)
    assert heard[0].pose.pose.position.x == pytest.approx(model.pose.translation[0], abs=1e-6)
    assert any("<odometrySource> no matching key to gps" in said for said in stage.said())


def test_the_messages_of_odometry_say_what_gazebo_says(stage):
    car(stage, odometryFrame="map", robotBaseFrame="base")
    odometry, transforms = stage.listen("/odom", ODOMETRY), stage.listen("/tf", TF)
    stage.run(0.06)
    (message,), (moved,) = odometry, (one for message in transforms for one in message.transforms)
    assert (message.header.frame_id, message.child_frame_id) == ("map", "base")
    unknown = 1e12
    assert [message.pose.covariance[7 * i] for i in range(6)] == [
        *(1e-5, 1e-5),
        *(unknown, unknown, unknown),
        1e-3,
    ]
    assert sum(map(bool, message.pose.covariance)) == 6
    assert not any(message.twist.covariance)
    assert (moved.header.frame_id, moved.child_frame_id) == ("map", "base")
    assert moved.header.stamp == message.header.stamp
    t, p = moved.transform.translation, message.pose.pose.position
    assert (t.x, t.y, t.z) == (p.x, p.y, p.z)


@pytest.mark.parametrize(
    ("tags", "topics", "transforms"),
    [
        ({}, {"/odom"}, 1),
        ({"publishOdomTF": "false"}, {"/odom"}, 0),
        ({"publishTf": "0"}, set(), 0),
        ({"publishWheelTF": "1", "publishTf": "false"}, set(), 2),
        ({"publishWheelJointState": "TRUE"}, {"/odom", "/joint_states"}, 1),
    ],
)
def test_each_report_can_be_chosen(stage, tags, topics, transforms):
    before = {one.topic for one in stage.gazebo.node.publishers}
    car(stage, **tags)
    heard = stage.listen("/tf", TF)
    stage.run(0.06)
    new = {one.topic for one in stage.gazebo.node.publishers} - before
    assert new - {"/tf"} == topics
    assert len(heard) == transforms


def test_joint_states_name_the_right_wheel_first_and_count_whole_turns(stage):
    model = car(stage, publishWheelJointState="true").model
    heard = stage.listen("/joint_states", "sensor_msgs/JointState")
    tell(stage, 0.0, 12.0)
    stage.run(0.502)
    last = heard[-1]
    assert last.name == ["right_joint", "left_joint"]
    assert (list(last.velocity), list(last.effort)) == ([], [])
    assert last.position[0] > 2.0 * math.pi
    assert last.position[1] < -2.0 * math.pi
    assert last.position[0] == pytest.approx(model.joint("right_joint").position, abs=0.05)
    assert stamps(heard)[-1] == 501


# -- names


def test_what_is_missing_is_told_with_its_default(stage):
    stage.spawn(f'{CAR}<gazebo><plugin name="d" filename="libgazebo_ros_diff_drive.so"/></gazebo>')
    told = [said for said in stage.said() if said.startswith("DiffDrive(ns = //): missing <")]
    defaults = [text.removeprefix("DiffDrive(ns = //): missing ") for text in told]
    assert defaults == [
        "<commandTopic> default is cmd_vel",
        "<odometryTopic> default is odom",
        "<odometryFrame> default is odom",
        "<robotBaseFrame> default is base_footprint",
        "<publishWheelTF> default is false",
        "<publishOdomTF> default is true",
        "<publishWheelJointState> default is false",
        "<wheelSeparation> default is 0.34",
        "<wheelDiameter> default is 0.15",
        "<wheelAcceleration> default is 0",
        "<wheelTorque> default is 5",
        "<updateRate> default is 100",
        "<odometrySource> default is world",
        "<leftJoint> default is left_joint",
        "<rightJoint> default is right_joint",
        "<publishTf> default is true",
    ]


def test_a_joint_that_is_not_there_keeps_the_plugin_away(stage):
    spawned = car(stage, leftJoint="left_jiont")
    (complaint,) = stage.said(LogLevel.ERROR)
    assert complaint.startswith("car.urdf:")
    assert "DiffDrive(ns = //): couldn't get wheel hinge joint named left_jiont" in complaint
    assert "did you mean left_joint?" in complaint
    assert spawned.plugins == ()
    assert spawned.model.joint("right_joint").mode is Mode.FREE


def test_a_topic_that_cannot_be_keeps_the_plugin_away(stage):
    spawned = car(stage, odometryTopic="my odom")
    assert spawned.plugins == ()
    assert "<odometryTopic>" in stage.said(LogLevel.ERROR)[0]


@pytest.mark.parametrize(
    ("spawning", "tags", "namespace"),
    [
        ({"namespace": None}, {}, "car"),
        ({"namespace": "/one"}, {}, "one"),
        ({"namespace": "/one"}, {"robotNamespace": "/two"}, "two"),
    ],
)
def test_in_a_namespace_topics_and_frames_have_its_name(stage, spawning, tags, namespace):
    model = car(stage, spawning=spawning, robotBaseFrame="base", **tags).model
    heard = stage.listen(f"/{namespace}/odom", ODOMETRY)
    tell(stage, 0.5, topic=f"/{namespace}/cmd_vel")
    stage.run(0.5)
    assert model.pose.translation[0] > 0.1
    assert heard[-1].header.frame_id == f"{namespace}/odom"
    assert heard[-1].child_frame_id == f"{namespace}/base"


def test_a_namespace_that_nobody_gives_is_told(stage):
    car(stage, spawning={"namespace": None})
    assert "DiffDrive missing <robotNamespace>, defaults is car" in stage.said(LogLevel.INFO)


def test_two_cars_in_two_namespaces_are_driven_each_by_its_own_commands(stage):
    one = car(stage, spawning={"namespace": "/one"}).model
    two = stage.spawn(driven(), name="other", pose=stage.at(y=2.0, z=0.1), namespace="/two").model
    tell(stage, 0.5, topic="/one/cmd_vel")
    stage.run(0.5)
    assert one.pose.translation[0] > 0.1
    assert abs(two.pose.translation[0]) < 1e-3


# -- reset


def test_a_reset_forgets_the_command_and_what_was_rolled(stage):
    model = car(stage, odometrySource="encoder").model
    heard = stage.listen("/odom", ODOMETRY)
    tell(stage, 0.5)
    stage.run(0.5)
    assert heard[-1].pose.pose.position.x > 0.1
    stage.gazebo.reset_world()
    stage.run(0.2)
    assert abs(heard[-1].pose.pose.position.x) < 1e-6
    assert abs(model.pose.translation[0]) < 1e-6
    assert [joint.mode for joint in model.joints.values()] == [Mode.VELOCITY] * 2
