"""The IMU feels gravity, and what moves it, as a real one does."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import rotate
from simkit.graph import LogLevel
from tests.simkit.plugins.samples import END_OF_SENSOR, NOISY_IMU, PENDULUM, Sample, in_sensor

SAMPLE = Sample(
    robot=PENDULUM,
    tags={"topicName": "imu", "frameName": "bob", "gaussianNoise": "0.01"},
    before=in_sensor("imu", NOISY_IMU, rate="100"),
    after=END_OF_SENSOR,
    rate_tag="updateRateHZ",
)

IMU = "sensor_msgs/Imu"
G = 9.8


@pytest.fixture
def imu(link):
    """Writes a box with an IMU."""

    def make(
        *,
        pose: str = "0 0 0 0 0 0",
        rate: float = 100,
        more: str = "",
        noise: str = "",
        sensor: str = "",
    ) -> str:
        return f"""{link()}<gazebo reference="base"><sensor name="imu" type="imu">
          <pose>{pose}</pose>{sensor}{f"<imu>{noise}</imu>" if noise else ""}
          <plugin name="imu" filename="libgazebo_ros_imu_sensor.so"><topicName>imu</topicName>
            <frameName>base</frameName><updateRateHZ>{rate}</updateRateHZ>{more}</plugin>
        </sensor></gazebo>"""

    return make


def vector(message) -> list[float]:
    return [message.x, message.y, message.z]


def test_at_rest_it_feels_the_ground_push_upward(stage, imu):
    stage.spawn(imu(), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.5)
    last = heard[-1]
    assert vector(last.linear_acceleration) == pytest.approx([0, 0, G], abs=1e-3)
    assert vector(last.angular_velocity) == pytest.approx([0, 0, 0], abs=1e-6)
    assert last.header.frame_id == "base"


def test_in_free_fall_it_feels_nothing(stage, imu):
    spawned = stage.spawn(imu(), pose=stage.at(z=5, roll=0.3, pitch=0.2))
    spawned.model.set_twist((1.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    heard = stage.listen("/imu", IMU)
    stage.run(0.3)
    assert len(heard) > 20
    for one in heard:
        assert vector(one.linear_acceleration) == pytest.approx([0, 0, 0], abs=1e-6)


def test_a_tilted_one_feels_gravity_in_its_own_axes(stage, imu):
    stage.spawn(imu(pose="0 0 0 0 0.5 0"), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.3)
    down = [-G * math.sin(0.5), 0, G * math.cos(0.5)]
    assert vector(heard[-1].linear_acceleration) == pytest.approx(down, abs=1e-3)


def test_it_measures_how_fast_it_turns_in_its_own_axes(stage, imu):
    spawned = stage.spawn(imu(pose=f"0 0 0 {math.pi / 2} 0 0"), pose=stage.at(z=5))
    spawned.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 0.7))
    heard = stage.listen("/imu", IMU)
    stage.run(0.1)
    assert vector(heard[-1].angular_velocity) == pytest.approx([0, 0.7, 0], abs=1e-4)


def test_off_the_axis_of_a_turn_it_feels_the_pull_to_the_middle(stage, imu):
    spawned = stage.spawn(imu(pose="0.5 0 0 0 0 0"), pose=stage.at(z=5))
    spawned.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 2.0))
    heard = stage.listen("/imu", IMU)
    stage.run(0.1)
    assert vector(heard[-1].linear_acceleration) == pytest.approx([-0.5 * 4, 0, 0], abs=0.01)


def test_orientation_is_that_of_the_world(stage, imu):
    stage.spawn(imu(), pose=stage.at(z=0.1, yaw=1.0))
    heard = stage.listen("/imu", IMU)
    stage.run(0.1)
    q = heard[-1].orientation
    assert [q.x, q.y, q.z, q.w] == pytest.approx([0, 0, math.sin(0.5), math.cos(0.5)], abs=1e-6)


def test_orientation_can_count_from_the_first_one(stage, imu):
    text = imu(more="<initialOrientationAsReference>true</initialOrientationAsReference>")
    spawned = stage.spawn(text, pose=stage.at(z=5, yaw=1.0))
    spawned.model.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 1.0))
    heard = stage.listen("/imu", IMU)
    stage.run(0.205)
    q = heard[-1].orientation
    ahead = rotate((q.x, q.y, q.z, q.w), (1.0, 0.0, 0.0))
    passed = heard[-1].header.stamp.to_sec()
    assert math.atan2(ahead[1], ahead[0]) == pytest.approx(passed, abs=1e-3)


def test_its_rate_is_kept(stage, imu):
    stage.spawn(imu(rate=50), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.205)
    stamps = [one.header.stamp.to_nsec() for one in heard]
    assert set(np.diff(stamps)) == {20_000_000}


def test_the_rate_of_the_sensor_bounds_that_of_the_plugin(stage, imu):
    stage.spawn(imu(rate=0, sensor="<update_rate>100</update_rate>"), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.205)
    stamps = [one.header.stamp.to_nsec() for one in heard]
    assert set(np.diff(stamps)) == {10_000_000}


def test_noise_of_the_plugin_is_on_all_values_and_in_the_covariances(stage, imu):
    more = "<gaussianNoise>0.1</gaussianNoise>"
    stage.spawn(imu(rate=0, more=more), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(1.0)
    late = heard[200:]
    for errors in (
        np.array([one.linear_acceleration.x for one in late]),
        np.array([one.angular_velocity.y for one in late]),
        np.array([one.orientation.z for one in late]),
    ):
        assert errors.mean() == pytest.approx(0, abs=0.1 * 4 / math.sqrt(len(late)))
        assert errors.std() == pytest.approx(0.1, rel=0.1)
    expected = (0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.01)
    assert late[0].orientation_covariance == pytest.approx(expected)
    assert late[0].angular_velocity_covariance == pytest.approx(expected)
    assert late[0].linear_acceleration_covariance == pytest.approx(expected)


def test_noise_of_one_axis_is_on_that_axis(stage, imu):
    gyro = '<angular_velocity><z><noise type="gaussian"><mean>0.5</mean></noise></z></angular_velocity>'
    stage.spawn(imu(noise=gyro), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.3)
    assert vector(heard[-1].angular_velocity) == pytest.approx([0, 0, 0.5], abs=1e-6)


def test_equal_seeds_give_equal_messages_and_others_do_not(new_stage, imu):
    def words(seed: int) -> list[bytes]:
        stage = new_stage(seed)
        stage.spawn(imu(more="<gaussianNoise>0.1</gaussianNoise>"), pose=stage.at(z=0.1))
        heard = stage.listen("/imu", IMU)
        stage.run(0.1)
        return [one.to_bytes() for one in heard]

    assert words(1) == words(1)
    assert words(1) != words(2)


def test_a_reset_repeats_the_noise(stage, imu):
    stage.spawn(imu(more="<gaussianNoise>0.1</gaussianNoise>"), pose=stage.at(z=0.1))
    heard = stage.listen("/imu", IMU)
    stage.run(0.1005)
    first = [vector(one.angular_velocity) for one in heard]
    heard.clear()
    stage.gazebo.reset_simulation()
    stage.run(0.1)
    assert [vector(one.angular_velocity) for one in heard][:5] == first[:5]


def test_without_a_frame_it_does_not_work_and_says_so(stage, imu):
    text = imu().replace("<frameName>base</frameName>", "")
    assert stage.spawn(text).plugins == ()
    assert "needs <frameName>" in stage.said(LogLevel.ERROR)[0]


def test_what_is_taken_where_nothing_is_given_is_told(stage, imu):
    text = imu().replace("<topicName>imu</topicName>", "")
    stage.spawn(text)
    assert stage.said() == ["missing <topicName>, set to default: imu_data"]
    assert "/imu_data" in stage.graph.topics
