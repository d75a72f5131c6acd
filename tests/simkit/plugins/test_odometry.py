"""The messages of odometry."""

from __future__ import annotations

import math

import pytest

from simkit.geometry import Transform, roll_pitch_yaw
from simkit.msgs import Time
from simkit.plugins.odometry import (
    UNKNOWN,
    BaseMotion,
    Covariances,
    EncoderOdometry,
    Frames,
    diagonal_covariance,
    odometry_message,
    planar_covariance,
    set_motion,
    set_transform,
    transform_message,
    world_motion,
)

FRAMES = Frames(parent="odom", child="base")
POSE = Transform((1.0, 2.0, 3.0), (0.0, 0.0, 0.6, 0.8))


def test_a_covariance_has_its_variances_in_the_diagonal():
    numbers = diagonal_covariance((1.0, 2.0, 3.0, 4.0, 5.0, 6.0))
    assert len(numbers) == 36
    assert [numbers[i] for i in (0, 7, 14, 21, 28, 35)] == [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    assert sum(numbers) == 21.0


def test_of_a_robot_on_wheels_three_of_six_are_known():
    numbers = planar_covariance(1.0, 2.0, 3.0)
    assert [numbers[7 * i] for i in range(6)] == [1.0, 2.0, UNKNOWN, UNKNOWN, UNKNOWN, 3.0]


def test_a_message_of_odometry_holds_pose_and_plane_motion():
    motion = BaseMotion(pose=POSE, linear=(0.1, 0.2), turning=0.3)
    message = odometry_message(FRAMES, Covariances(pose=[1.0] * 36, twist=[2.0] * 36))
    set_motion(message, motion, Time(5))
    assert (message.pose.covariance[0], message.twist.covariance[0]) == (1.0, 2.0)
    assert (message.header.frame_id, message.child_frame_id) == ("odom", "base")
    assert message.header.stamp == Time(5)
    p, q, twist = message.pose.pose.position, message.pose.pose.orientation, message.twist.twist
    assert ((p.x, p.y, p.z), (q.x, q.y, q.z, q.w)) == POSE
    assert (twist.linear.x, twist.linear.y, twist.angular.z) == (0.1, 0.2, 0.3)
    message.to_bytes()


def test_a_transform_holds_the_same_pose():
    message = transform_message(FRAMES)
    set_transform(message, POSE, Time(5))
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


STEP = 1e-3


def rolled(left: float, right: float, seconds: float, separation: float = 0.4) -> EncoderOdometry:
    """Two wheels whose rims move at these speeds [m/s] for a time."""
    odometry = EncoderOdometry(separation)
    for _ in range(round(seconds / STEP)):
        odometry.advance(left * STEP, right * STEP, STEP)
    return odometry


def test_equal_wheels_go_straight():
    motion = rolled(0.5, 0.5, 2.0).motion
    assert motion.pose.translation == pytest.approx((1.0, 0.0, 0.0), abs=1e-12)
    assert motion.pose.rotation == pytest.approx((0.0, 0.0, 0.0, 1.0), abs=1e-12)
    assert motion.linear == pytest.approx((0.5, 0.0))
    assert motion.turning == 0.0


def test_a_faster_right_wheel_turns_left_on_a_circle():
    left, right, separation = 0.2, 0.4, 0.4
    turning, speed = (right - left) / separation, (left + right) / 2
    motion = rolled(left, right, math.pi / turning, separation).motion
    assert roll_pitch_yaw(motion.pose.rotation)[2] == pytest.approx(math.pi, abs=1e-3)
    assert motion.pose.translation == pytest.approx((0.0, 2 * speed / turning, 0.0), abs=2e-3)
    assert motion.turning == pytest.approx(turning)


def test_opposite_wheels_turn_on_the_spot():
    motion = rolled(-0.2, 0.2, 1.0).motion
    assert motion.pose.translation == (0.0, 0.0, 0.0)
    assert roll_pitch_yaw(motion.pose.rotation)[2] == pytest.approx(1.0)
    assert motion.linear == (0.0, 0.0)


def test_the_speed_is_a_length_also_when_it_goes_backwards():
    motion = rolled(-0.5, -0.5, 1.0).motion
    assert motion.pose.translation[0] == pytest.approx(-0.5)
    assert motion.linear[0] == pytest.approx(0.5)


def test_who_believes_in_wheels_that_are_too_far_apart_believes_to_turn_too_little():
    believed = rolled(-0.15, 0.15, 1.0, separation=0.4).motion
    assert roll_pitch_yaw(believed.pose.rotation)[2] == pytest.approx(0.75)


def test_a_step_is_made_in_the_middle_of_its_turn():
    odometry = EncoderOdometry(1.0)
    odometry.advance(0.0, 1.0, 1.0)
    x, y, _ = odometry.motion.pose.translation
    assert (x, y) == pytest.approx((0.5 * math.cos(0.5), 0.5 * math.sin(0.5)))


def test_reset_is_the_beginning():
    odometry = rolled(0.2, 0.4, 0.5)
    odometry.reset()
    assert odometry.motion == EncoderOdometry(0.4).motion
