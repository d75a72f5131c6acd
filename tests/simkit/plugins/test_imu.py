"""The old IMU plugin: as Gazebo has it, without gravity."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.graph import LogLevel
from simkit.msgs import service_class
from tests.simkit.plugins.samples import PENDULUM, Sample

SAMPLE = Sample(
    robot=PENDULUM,
    tags={
        "bodyName": "bob",
        "topicName": "imu",
        "serviceName": "calibrate",
        "gaussianNoise": "0.01",
    },
    rate_tag="updateRate",
)

IMU = "sensor_msgs/Imu"


@pytest.fixture
def imu(link):
    """Writes a box with an IMU."""

    def make(more: str = "", rate: float = 100) -> str:
        return f"""{link()}<gazebo><plugin name="imu" filename="libgazebo_ros_imu.so">
          <bodyName>base</bodyName><topicName>imu</topicName><updateRate>{rate}</updateRate>{more}
        </plugin></gazebo>"""

    return make


def vector(message) -> list[float]:
    return [message.x, message.y, message.z]


def test_at_rest_it_says_nothing_and_a_hint_says_that_this_is_not_what_a_real_one_does(stage, imu):
    stage.spawn(imu(), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.5)
    assert vector(heard[-1].linear_acceleration) == pytest.approx([0, 0, 0], abs=1e-3)
    assert heard[-1].header.frame_id == "base"
    (hint,) = [one for one in stage.said(LogLevel.INFO) if "gravity" in one]
    assert "libgazebo_ros_imu_sensor.so" in hint


def test_in_free_fall_it_says_how_it_falls(stage, imu):
    stage.spawn(imu(), pose=stage.at(z=5))
    heard = stage.listen("/imu", IMU)
    stage.run(0.2)
    assert vector(heard[-1].linear_acceleration) == pytest.approx([0, 0, -9.8], abs=1e-6)


def test_turn_rate_and_orientation(stage, imu):
    spawned = stage.spawn(imu("<rpyOffset>0 0 0.5</rpyOffset>"), pose=stage.at(z=5, yaw=0.2))
    spawned.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 0.7))
    heard = stage.listen("/imu", IMU)
    stage.run(0.105)
    assert vector(heard[-1].angular_velocity) == pytest.approx([0, 0, 0.7], abs=1e-4)
    q = heard[-1].orientation
    yaw = 0.7 + 0.7 * heard[-1].header.stamp.to_sec()
    assert 2 * math.atan2(q.z, q.w) == pytest.approx(yaw, abs=1e-3)


def test_vectors_of_the_world_are_turned_by_the_orientation_as_in_the_original(stage, imu):
    spawned = stage.spawn(imu(), pose=stage.at(z=5, roll=math.pi / 2))
    spawned.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.7, 0.0))
    heard = stage.listen("/imu", IMU)
    stage.run(0.012)
    assert vector(heard[0].angular_velocity) == pytest.approx([0, 0, 0.7], abs=0.02)


def test_its_rate_is_kept(stage, imu):
    stage.spawn(imu(rate=50), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.205)
    assert set(np.diff([one.header.stamp.to_nsec() for one in heard])) == {20_000_000}


def test_noise_and_its_square(stage, imu):
    stage.spawn(imu("<gaussianNoise>0.2</gaussianNoise>", rate=0), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(1.0)
    errors = np.array([one.angular_velocity.x for one in heard[200:]])
    assert errors.std() == pytest.approx(0.2, rel=0.1)
    assert heard[0].angular_velocity_covariance[::4] == pytest.approx((0.04, 0.04, 0.04))


def test_its_service_answers_and_leaves_with_it(stage, imu):
    stage.spawn(imu("<serviceName>calibrate</serviceName>"))
    assert "/calibrate" in stage.graph.services
    assert isinstance(stage.graph.services["/calibrate"].node_name, str)
    stage.gazebo.delete("r")
    assert "/calibrate" not in stage.graph.services
    assert service_class("std_srvs/Empty")._type == "std_srvs/Empty"


def test_a_body_that_is_not_there_is_told(stage, imu):
    assert stage.spawn(imu().replace(">base<", ">bse<")).plugins == ()
    (error,) = stage.said(LogLevel.ERROR)
    assert "bodyName: bse does not exist; links that are simulated: base" in error


def test_three_numbers_are_three(stage, imu):
    assert stage.spawn(imu("<rpyOffset>0 0</rpyOffset>")).plugins == ()
    assert "<rpyOffset> is three numbers" in stage.said(LogLevel.ERROR)[0]
