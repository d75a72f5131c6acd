"""`libgazebo_ros_imu.so`: orientation, turn rate and acceleration of a link, as this old plugin gives them.

It is no accelerometer: at rest it says 0, not 9.8. And it turns vectors of the world by the orientation
of the link where it should turn them back. Programs that were tuned with Gazebo know it like this;
`libgazebo_ros_imu_sensor.so` is right on both counts, and a hint says so.

Source: gazebo_ros_imu of Melodic and Noetic; gazebo_ros_pkgs 468 on the missing gravity.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from simkit.geometry import Quaternion, Vector, multiply, rotate
from simkit.msgs import Time, message_class, service_class
from simkit.plugins.noise import generator
from simkit.plugins.parameters import read_triple, read_turn, topic_at_root
from simkit.plugins.plugin import NEVER, Plugin
from simkit.plugins.site import PluginError, Site
from simkit.plugins.tags import ImuParameters


class Imu(Plugin[ImuParameters]):
    """An IMU without gravity; it computes while someone listens."""

    Parameters = ImuParameters

    def __init__(self, site: Site, parameters: ImuParameters) -> None:
        super().__init__(site, parameters)
        if parameters.body not in site.model.links:
            where = site.place(site.element.child("bodyName") or site.element)
            raise PluginError(
                f"{where}: gazebo_ros_imu plugin error: bodyName: {parameters.body} does not exist; "
                f"links that are simulated: {', '.join(site.model.links) or 'none'}"
            )
        read_triple(site, "xyzOffset", parameters.xyz)
        self._offset = read_turn(site, "rpyOffset", parameters.rpy)
        self._period_ns = round(1e9 / parameters.rate) if parameters.rate > 0.0 else 0
        self._publisher: Any = None
        self._service: Any = None
        self._random = self._generator()
        self._last_ns = site.now_ns
        self._velocity, _ = site.model.link_twist(parameters.body)
        self._acceleration: Vector = (0.0, 0.0, 0.0)

    def on_attach(self) -> None:
        """Offer the topic and the service."""
        site, parameters = self.site, self.parameters
        if not parameters.topic:
            return
        self._publisher = site.node.advertise(
            topic_at_root(site, "topicName", parameters.topic),
            message_class("sensor_msgs/Imu"),
            queue_size=1,
        )
        empty: Any = service_class("std_srvs/Empty")
        self._service = site.node.advertise_service(
            topic_at_root(site, "serviceName", parameters.service),
            empty,
            lambda _: empty._response_class(),
        )
        site.node.info(
            f"{site.place(site.element)}: libgazebo_ros_imu.so leaves gravity out: at rest it says 0, "
            "where a real IMU says 9.8 m/s^2 upward. libgazebo_ros_imu_sensor.so has it"
        )

    @property
    def due_ns(self) -> int:
        """Each period, if someone listens."""
        return self._last_ns + self._period_ns if self._has_listener else NEVER

    def before_step(self) -> None:
        """Publish, if someone listens and it is time."""
        now_ns = self.site.now_ns
        if self._has_listener and now_ns - self._last_ns >= self._period_ns:
            self._publisher.publish(self._message(now_ns))
            self._last_ns = now_ns

    def on_reset(self) -> None:
        """The same noise again, from a standstill."""
        self._random = self._generator()
        self._last_ns = self.site.now_ns
        self._velocity, _ = self.site.model.link_twist(self.parameters.body)
        self._acceleration = (0.0, 0.0, 0.0)

    def on_detach(self) -> None:
        """Withdraw topic and service."""
        for endpoint in (self._publisher, self._service):
            if endpoint is not None:
                endpoint.unregister()

    @property
    def _has_listener(self) -> bool:
        return self._publisher is not None and self._publisher.num_connections > 0

    def _generator(self) -> np.random.Generator:
        return generator(self.site.seed("imu", self.site.name))

    def _message(self, now_ns: int) -> Any:
        model, parameters = self.site.model, self.parameters
        linear, angular = model.link_twist(parameters.body)
        elapsed_s = (now_ns - self._last_ns) * 1e-9
        if elapsed_s > 0.0:
            (x, y, z), (px, py, pz) = linear, self._velocity
            self._acceleration = ((x - px) / elapsed_s, (y - py) / elapsed_s, (z - pz) / elapsed_s)
            self._velocity = linear
        turn = multiply(self._offset, model.link_pose(parameters.body).rotation)
        return imu_message(
            stamp_ns=now_ns,
            frame=parameters.frame or parameters.body,
            orientation=turn,
            angular_velocity=rotate(turn, self._noisy(angular)),
            linear_acceleration=rotate(turn, self._noisy(self._acceleration)),
            noise=parameters.noise,
        )

    def _noisy(self, vector: Vector) -> Vector:
        x, y, z = vector
        if self.parameters.noise == 0.0:
            return vector
        dx, dy, dz = self._random.normal(0.0, self.parameters.noise, 3).tolist()
        return (x + dx, y + dy, z + dz)


def imu_message(
    *,
    stamp_ns: int,
    frame: str,
    orientation: Quaternion,
    angular_velocity: Vector,
    linear_acceleration: Vector,
    noise: float,
) -> Any:
    """The message.

    Args:
        stamp_ns: Time of the measurement [ns].
        frame: Frame of the header.
        orientation: xyzw.
        angular_velocity: [rad/s].
        linear_acceleration: [m/s^2].
        noise: Standard deviation; its square stands in the diagonals of all three covariances.
    """
    message: Any = message_class("sensor_msgs/Imu")()
    message.header.stamp = Time.from_nsec(stamp_ns)
    message.header.frame_id = frame
    turn, rate, push = message.orientation, message.angular_velocity, message.linear_acceleration
    turn.x, turn.y, turn.z, turn.w = orientation
    rate.x, rate.y, rate.z = angular_velocity
    push.x, push.y, push.z = linear_acceleration
    v = noise * noise
    for part in ("orientation", "angular_velocity", "linear_acceleration"):
        setattr(message, f"{part}_covariance", [v, 0.0, 0.0, 0.0, v, 0.0, 0.0, 0.0, v])
    return message
