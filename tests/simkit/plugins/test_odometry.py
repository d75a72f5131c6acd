"""The messages of odometry."""

from __future__ import annotations

import math

import pytest

from simkit.geometry import Transform, roll_pitch_yaw
from simkit.msgs import Time
from simkit.plugins.odometry import (
    UNKNOWN,
    Frames,
    Motion,
    diagonal,
    odometry_message,
    planar_covariance,
    transform_message,
    world_motion,
)

FRAMES = Frames(parent="odom", child="base")
POSE = Transform((1.0, 2.0, 3.0), (0.0, 0.0, 0.6, 0.8))


def test_a_covariance_has_its_variances_in_the_diagonal():
    numbers = diagonal((1.0, 2.0, 3.0, 4.0, 5.0, 6.0))
    assert len(numbers) == 36
    assert [numbers[i] for i in (0, 7, 14, 21, 28, 35)] == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    assert sum(numbers) == 21.0


def test_of_a_robot_on_wheels_three_of_six_are_known():
    numbers = planar_covariance(1.0, 2.0, 3.0)
    assert [numbers[7 * i] for i in range(6)] == [1.0, 2.0, UNKNOWN, UNKNOWN, UNKNOWN, 3.0]


def test_a_message_of_odometry_holds_pose_and_plane_motion():
    motion = Motion(pose=POSE, linear=(0.1, 0.2), turning=0.3)
    message = odometry_message(motion, FRAMES, Time(5))
    assert (message.header.frame_id, message.child_frame_id) == ("odom", "base")
    assert message.header.stamp == Time(5)
    p, q, twist = message.pose.pose.position, message.pose.pose.orientation, message.twist.twist
    assert ((p.x, p.y, p.z), (q.x, q.y, q.z, q.w)) == POSE
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (0.1, 0.2, 0.3)
    message.to_bytes()


def test_a_transform_holds_the_same_pose():
    message = transform_message(POSE, FRAMES, Time(5))
    t, q = message.transform.translation, message.transform.rotation
    assert ((t.x, t.y, t.z), (q.x, q.y, q.z, q.w)) == POSE
    assert (message.header.frame_id, message.child_frame_id) == ("odom", "base")
    message.to_bytes()


@pytest.mark.parametrize("yaw", [0.0, 0.7, math.pi, -2.0])
def test_velocities_are_seen_from_the_robot(stage, link, yaw):
    model = stage.spawn(link(), pose=stage.at(z=5.0, yaw=yaw)).model
    model.set_twist((math.cos(yaw), math.sin(yaw), 0.0), (0.0, 0.0, 0.4))
    motion = world_motion(model)
    assert motion.linear == pytest.approx((1.0, 0.0))
    assert motion.turning == pytest.approx(0.4)
    assert motion.pose.translation == pytest.approx((0.0, 0.0, 5.0))
    turned = roll_pitch_yaw(motion.pose.rotation)[2]
    assert math.cos(turned - yaw) == pytest.approx(1.0)
