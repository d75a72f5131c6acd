"""The plugin that tells where a link is in truth."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import conjugate, multiply, roll_pitch_yaw, rotate
from simkit.graph import LogLevel
from tests.simkit.plugins.samples import PENDULUM, Sample

SAMPLE = Sample(
    robot=PENDULUM,
    tags={"bodyName": "bob", "topicName": "truth", "gaussianNoise": "0.01"},
    rate_tag="updateRate",
)

ODOMETRY = "nav_msgs/Odometry"
LINK = "<bodyName>bob</bodyName>"
TOPIC = "<topicName>truth</topicName>"


@pytest.fixture
def swinging(stage):
    """Spawns a pendulum with a plugin that says this, and what is so after each step."""

    def make(inside="", *, body=LINK, topic=TOPIC, on=None, **options):
        on = on or stage
        spawned = on.spawn(
            f'{PENDULUM}\n<gazebo><plugin name="p" filename="libgazebo_ros_p3d.so">\n'
            f"{body}{topic}\n{inside}</plugin></gazebo>",
            name="swinging",
            **options,
        )
        truth, model = {}, spawned.model
        on.gazebo.world.after_step.append(
            lambda: truth.update(
                {on.graph.executor.now_ns: (model.link_pose("bob"), model.link_twist("bob"))}
            )
        )
        return spawned, truth

    return make


def pose_of(message):
    p, q = message.pose.pose.position, message.pose.pose.orientation
    return (p.x, p.y, p.z), (q.x, q.y, q.z, q.w)


def twist_of(message):
    linear, angular = message.twist.twist.linear, message.twist.twist.angular
    return (linear.x, linear.y, linear.z), (angular.x, angular.y, angular.z)


def same_turn(one, other) -> bool:
    return abs(sum(a * b for a, b in zip(one, other, strict=True))) == pytest.approx(1.0)


def test_it_tells_where_a_link_is_and_how_it_moves(stage, swinging):
    _, truth = swinging()
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.2)
    assert len(heard) >= 199
    for message in heard[::20]:
        pose, twist = truth[message.header.stamp.to_nsec()]
        told = pose_of(message)
        assert told[0] == pytest.approx(pose.translation)
        assert same_turn(told[1], pose.rotation)
        assert twist_of(message) == (pytest.approx(twist[0]), pytest.approx(twist[1]))
        assert (message.header.frame_id, message.child_frame_id) == ("world", "bob")
    assert not any(heard[0].pose.covariance)


def test_it_tells_at_most_so_often_and_first_after_a_period(stage, swinging):
    swinging("<updateRate>20</updateRate>")
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.16)
    stamps = [message.header.stamp.to_nsec() // 1_000_000 for message in heard]
    assert stamps == [50, 100, 150]


def test_a_period_is_rounded_up_to_whole_steps_each_time(stage, swinging):
    swinging("<updateRate>30</updateRate>")
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.11)
    stamps = [message.header.stamp.to_nsec() // 1_000_000 for message in heard]
    assert stamps == [34, 68, 102]


def test_who_comes_late_is_told_at_once(stage, swinging):
    swinging("<updateRate>20</updateRate>")
    stage.run(0.13)
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.06)
    stamps = [message.header.stamp.to_nsec() // 1_000_000 for message in heard]
    assert stamps == [131, 181]


@pytest.mark.parametrize(
    ("frame", "told"), [("world", "world"), ("/world", "world"), ("map", "map"), ("/map", "map")]
)
def test_the_world_has_four_names(stage, swinging, frame, told):
    _, truth = swinging(f"<frameName>{frame}</frameName>")
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.01)
    pose, _ = truth[heard[0].header.stamp.to_nsec()]
    assert heard[0].header.frame_id == told
    assert pose_of(heard[0])[0] == pytest.approx(pose.translation)


def test_offsets_are_added_and_turn(stage, swinging):
    _, truth = swinging(
        "<xyzOffset>25.65 25.65 0</xyzOffset><rpyOffset>0 0 1.5707963267948966</rpyOffset>"
    )
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.1)
    pose, _ = truth[heard[-1].header.stamp.to_nsec()]
    x, y, z = pose.translation
    position, rotation = pose_of(heard[-1])
    assert position == pytest.approx((x + 25.65, y + 25.65, z))
    quarter = (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5))
    assert same_turn(rotation, multiply(quarter, pose.rotation))


def test_from_another_link_it_tells_what_gazebo_tells(stage, swinging):
    spawned, truth = swinging(
        "<frameName>base</frameName>", pose=stage.at(1.0, 2.0, 0.0, 0.0, 0.0, 0.5)
    )
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.1)
    frame = spawned.model.link_pose("base")
    pose, (linear, angular) = truth[heard[-1].header.stamp.to_nsec()]
    away = tuple(a - b for a, b in zip(pose.translation, frame.translation, strict=True))
    position, rotation = pose_of(heard[-1])
    assert position == pytest.approx(rotate(conjugate(frame.rotation), away))
    assert same_turn(rotation, multiply(pose.rotation, conjugate(frame.rotation)))
    told = twist_of(heard[-1])
    assert told[0] == pytest.approx(rotate(frame.rotation, linear))
    assert told[1] == pytest.approx(rotate(frame.rotation, angular))
    assert heard[-1].header.frame_id == "base"


def test_velocities_can_be_seen_from_the_link(stage, swinging):
    _, truth = swinging("<localTwist>true</localTwist>")
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.1)
    pose, (linear, angular) = truth[heard[-1].header.stamp.to_nsec()]
    told = twist_of(heard[-1])
    assert rotate(pose.rotation, told[0]) == pytest.approx(linear)
    assert rotate(pose.rotation, told[1]) == pytest.approx(angular)
    assert abs(roll_pitch_yaw(pose.rotation)[0]) > 0.1


def test_noise_is_on_velocities_alone_and_as_large_as_it_says(stage, swinging):
    _, truth = swinging("<gaussianNoise>0.05</gaussianNoise>")
    heard = stage.listen("/truth", ODOMETRY)
    stage.run(0.6)
    errors = []
    for message in heard:
        pose, twist = truth[message.header.stamp.to_nsec()]
        assert pose_of(message)[0] == pytest.approx(pose.translation)
        errors += list(np.subtract(np.ravel(twist_of(message)), np.ravel(twist)))
    assert np.std(errors) == pytest.approx(0.05, rel=0.05)
    assert abs(np.mean(errors)) < 0.004
    for covariance in (heard[0].pose.covariance, heard[0].twist.covariance):
        assert [covariance[7 * i] for i in range(6)] == pytest.approx([0.0025] * 6)
        assert sum(map(bool, covariance)) == 6


def test_noise_depends_on_the_seed_alone(new_stage, swinging):
    velocities = []
    for seed in (1, 1, 2):
        on = new_stage(seed)
        swinging("<gaussianNoise>0.05</gaussianNoise>", on=on)
        heard = on.listen("/truth", ODOMETRY)
        on.run(0.01)
        velocities.append(twist_of(heard[-1]))
    assert velocities[0] == velocities[1]
    assert velocities[0] != velocities[2]


def test_nobody_listens_nobody_is_told(stage, swinging):
    swinging()
    stage.run(0.05)
    assert stage.graph.topics["/truth"].last is None


@pytest.mark.parametrize(
    ("tags", "complaint"),
    [
        ({"body": "<bodyName>bobb</bodyName>"}, "bodyName: bobb does not exist; did you mean bob?"),
        ({"inside": "<frameName>odom</frameName>"}, "frameName: odom does not exist"),
        ({"inside": "<xyzOffset>1 2</xyzOffset>"}, "<xyzOffset> is three numbers"),
        ({"body": ""}, "<bodyName>"),
        ({"topic": ""}, "<topicName>"),
        ({"topic": "<topicName/>"}, "<topicName>"),
    ],
)
def test_what_cannot_be_keeps_the_plugin_away(stage, swinging, tags, complaint):
    spawned, _ = swinging(**tags)
    (said,) = stage.said(LogLevel.ERROR)
    assert said.startswith("swinging.urdf:")
    assert complaint in said
    assert spawned.plugins == ()


def test_the_old_spelling_of_an_offset_is_not_read(stage, swinging):
    swinging("<xyzOffsets>1 2 3</xyzOffsets>")
    assert any("reads no parameter <xyzOffsets>" in s for s in stage.said())  # so says check_urdf


@pytest.mark.parametrize(
    ("namespace", "topic"), [("/", "/truth"), ("/one", "/one/truth"), (None, "/truth")]
)
def test_without_a_namespace_its_topic_is_at_the_root(stage, swinging, namespace, topic):
    swinging(namespace=namespace)
    heard = stage.listen(topic, ODOMETRY)
    stage.run(0.005)
    assert heard
