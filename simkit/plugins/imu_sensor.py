"""`libgazebo_ros_imu_sensor.so`: an IMU on a link, which feels gravity as a real one does.

Source: gazebo_ros_imu_sensor of Noetic, and Gazebo's `ImuSensor`. That one takes the lever of a sensor
that is not in the origin of its link with the wrong sign; here it has the sign of physics.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from simkit.geometry import Vector, conjugate, multiply, rotate
from simkit.msgs import message_class
from simkit.plugins.imu import imu_message
from simkit.plugins.noise import AxisNoise, generator
from simkit.plugins.parameters import read_triple, read_turn, topic_of
from simkit.plugins.plugin import NEVER, Plugin
from simkit.plugins.rate import SensorRate
from simkit.plugins.sensor_tag import read_sensor, sensor_pose
from simkit.plugins.site import Site
from simkit.plugins.tags import ImuSensorParameters


class ImuSensor(Plugin[ImuSensorParameters]):
    """An IMU; it measures while someone listens."""

    Parameters = ImuSensorParameters

    def __init__(self, site: Site, parameters: ImuSensorParameters) -> None:
        super().__init__(site, parameters)
        self.sensor = read_sensor(site, "imu")
        read_triple(site, "xyzOffset", parameters.xyz)
        self._offset = read_turn(site, "rpyOffset", parameters.rpy)
        self._reference = (0.0, 0.0, 0.0, 1.0)
        if parameters.from_start:
            self._reference = conjugate(sensor_pose(site, self.sensor).rotation)
        self._noises = [
            AxisNoise(site, self.sensor, quantity)
            for quantity in ("angular_velocity", "linear_acceleration")
        ]
        self._measures = SensorRate(self.sensor.update_rate, site.now_ns)
        self._period_ns = round(1e9 / parameters.rate) if parameters.rate > 0.0 else 0
        self._publisher: Any = None
        self._random = self._generator()
        self._published_ns = site.now_ns
        self._before: tuple[int, Vector] | None = self._moment()

    def on_attach(self) -> None:
        """Offer the topic."""
        for name, value in (("topicName", "imu_data"), ("updateRateHZ", "1")):
            if self.site.element.child(name) is None:
                self.site.node.warn(f"missing <{name}>, set to default: {value}")
        topic = topic_of(self.site, "topicName", self.parameters.topic)
        self._publisher = self.site.node.advertise(
            topic, message_class("sensor_msgs/Imu"), queue_size=1
        )

    @property
    def due_ns(self) -> int:
        """When it measures next, if someone listens; at once if it has to forget what it measured."""
        if self._publisher.num_connections:
            return self._measures.due_ns
        return NEVER if self._before is None else 0

    def after_step(self) -> None:
        """Measure, and publish if it is time, while someone listens."""
        if not self._publisher.num_connections:
            self._before = None
            return
        now_ns = self.site.now_ns
        if not self._measures.is_due(now_ns):
            return
        pose = sensor_pose(self.site, self.sensor)
        back = conjugate(pose.rotation)
        velocity, angular = self._twist(pose.translation)
        before, self._before = self._before, (now_ns, velocity)
        if before is None or now_ns - self._published_ns < self._period_ns:
            return
        self._published_ns = now_ns
        gyro, push = self._noises
        message = imu_message(
            stamp_ns=now_ns,
            frame=self.parameters.frame,
            orientation=multiply(self._offset, multiply(self._reference, pose.rotation)),
            angular_velocity=gyro.apply(rotate(back, angular)),
            linear_acceleration=push.apply(rotate(back, self._felt(before, now_ns, velocity))),
            noise=self.parameters.noise,
        )
        self._publisher.publish(self._noisy(message))

    def on_reset(self) -> None:
        """The same noise again, from a standstill."""
        self._measures.restart(self.site.now_ns)
        for noise in self._noises:
            noise.restart()
        self._random = self._generator()
        self._published_ns = self.site.now_ns
        self._before = self._moment()

    def on_detach(self) -> None:
        """Withdraw the topic."""
        self._publisher.unregister()

    def _moment(self) -> tuple[int, Vector]:
        """The time, and how fast the sensor is now."""
        at = sensor_pose(self.site, self.sensor).translation
        return self.site.now_ns, self._twist(at)[0]

    def _generator(self) -> np.random.Generator:
        return generator(self.site.seed("imu", self.sensor.name))

    def _twist(self, at: Vector) -> tuple[Vector, Vector]:
        """Velocity of the point at which the sensor is, and angular velocity, in the world."""
        (vx, vy, vz), angular = self.site.model.link_twist(self.sensor.link)
        ox, oy, oz = self.site.model.link_pose(self.sensor.link).translation
        x, y, z = at[0] - ox, at[1] - oy, at[2] - oz
        wx, wy, wz = angular
        return (vx + wy * z - wz * y, vy + wz * x - wx * z, vz + wx * y - wy * x), angular

    def _felt(self, before: tuple[int, Vector], now_ns: int, velocity: Vector) -> Vector:
        """Acceleration less that of free fall, in the world [m/s^2]."""
        elapsed_s = (now_ns - before[0]) * 1e-9
        x, y, z = (
            (new - old) / elapsed_s - g
            for new, old, g in zip(velocity, before[1], self.site.world.gravity, strict=True)
        )
        return (x, y, z)

    def _noisy(self, message: Any) -> Any:
        """The message with the noise of the plugin: on all values, also on the four of the quaternion."""
        if self.parameters.noise > 0.0:
            parts = ("orientation", "linear_acceleration", "angular_velocity")
            for part in (getattr(message, name) for name in parts):
                for axis in part.__slots__:
                    value = getattr(part, axis) + self._random.normal(0.0, self.parameters.noise)
                    setattr(part, axis, float(value))
        return message
