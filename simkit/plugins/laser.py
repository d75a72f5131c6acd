"""`libgazebo_ros_laser.so`: a laser that publishes what it sees.

Source: gazebo_ros_laser of Noetic; Gazebo 9 and 11 `RaySensor`, `MultiRayShape` and `Sensor`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from simkit.msgs import Time, message_class
from simkit.physics import MISS
from simkit.plugins.beams import Floats, directions, read_ray, resampled
from simkit.plugins.noise import Noise
from simkit.plugins.parameters import resolve_frame, tf_prefix, topic_of
from simkit.plugins.plugin import NEVER, Plugin
from simkit.plugins.rate import SensorRate
from simkit.plugins.sensor_tag import read_sensor, sensor_pose
from simkit.plugins.site import Site
from simkit.plugins.tags import LASER_DEFAULT, LaserParameters


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """What the beams of a laser hit, without noise."""

    points: Floats
    """Where each beam ends in the world [m], (n, 3); NaN where it hits nothing within its reach."""
    ranges: Floats
    """How far that is from the laser [m], (n,); inf where it hits nothing, -inf right where a beam begins."""
    targets: NDArray[np.intp]
    """Number of the shape that each beam hits, (n,): its place in `World.targets`; -1 if none."""


class Laser(Plugin[LaserParameters]):
    """A laser on a link; it computes while someone listens to its topic, and at no other time.

    Beams hit collision shapes, also those of the robot itself.
    """

    Parameters = LaserParameters

    def __init__(self, site: Site, parameters: LaserParameters) -> None:
        super().__init__(site, parameters)
        self.sensor = read_sensor(site, "ray")
        self.ray = read_ray(site, self.sensor)
        self.frame = resolve_frame(parameters.frame, tf_prefix(site))
        self._fan = np.ascontiguousarray(directions(self.ray).T)
        self._rate = SensorRate(self.sensor.update_rate, site.now_ns)
        noise = self.ray.noise
        self._noise = None if noise is None else Noise(noise, site.seed("laser", self.sensor.name))
        self._scan = self._new_scan()
        self._publisher: Any = None

    @property
    def name(self) -> str:
        """Name of the sensor."""
        return self.sensor.name

    def on_attach(self) -> None:
        """Offer the topic."""
        for name in ("frameName", "topicName"):
            if self.site.element.child(name) is None:
                self.site.node.info(f"Laser plugin missing <{name}>, defaults to {LASER_DEFAULT}")
        if self.parameters.topic:
            topic = topic_of(self.site, "topicName", self.parameters.topic)
            self._publisher = self.site.node.advertise(topic, type(self._scan), queue_size=1)

    @property
    def due_ns(self) -> int:
        """When it measures next, if someone listens."""
        return self._rate.due_ns if self._has_listener else NEVER

    def after_step(self) -> None:
        """Measure, if someone listens and it is time."""
        if self._has_listener and self._rate.is_due(self.site.now_ns):
            self._publisher.publish(self._message())

    def on_reset(self) -> None:
        """The same noise again."""
        self._rate.restart(self.site.now_ns)
        if self._noise is not None:
            self._noise.restart()

    def on_detach(self) -> None:
        """Withdraw the topic."""
        if self._publisher is not None:
            self._publisher.unregister()

    def scan_points(self) -> Sight:
        """What the beams hit now, for views; asking changes nothing."""
        origin, ways, ranges, targets = self._cast()
        seen = (targets != MISS) & (ranges < self.ray.far)
        points = np.full_like(ways, np.nan)
        points[seen] = origin + ways[seen] * ranges[seen][:, None]
        return Sight(points, self._masked(ranges, ranges), np.where(seen, targets, MISS))

    @property
    def _has_listener(self) -> bool:
        return self._publisher is not None and self._publisher.num_connections > 0

    def _cast(self) -> tuple[Floats, Floats, Floats, NDArray[np.intp]]:
        """Where beams come from, where they go, how far they get from there, and what they hit."""
        pose = sensor_pose(self.site, self.sensor)
        ways = (np.array(pose.matrix) @ self._fan).T
        near = self.ray.near
        reach = max(near, self.ray.far)
        hits = self.site.world.cast_rays(pose.translation, ways, reach=reach, start=near)
        return np.array(pose.translation), ways, np.minimum(hits.distances, reach), hits.targets

    def _masked(self, ranges: Floats, measured: Floats) -> Floats:
        """What is measured of ranges, as REP 117 wants it."""
        far, near = self.ray.far, self.ray.near
        return np.where(ranges >= far, np.inf, np.where(ranges <= near, -np.inf, measured))

    def _new_scan(self) -> Any:
        """The message with all that stays as it is."""
        message: Any = message_class("sensor_msgs/LaserScan")()
        message.header.frame_id = self.frame
        message.angle_min, message.angle_max = self.ray.flat.min_angle, self.ray.flat.max_angle
        message.angle_increment = self.ray.flat.step
        message.range_min, message.range_max = self.ray.near, self.ray.far
        return message

    def _message(self) -> Any:
        _, _, ranges, targets = self._cast()
        intensities = self._retro(targets)
        if self.ray.is_resampled:
            ranges = resampled(self.ray, ranges, blend=True)
            intensities = resampled(self.ray, intensities, blend=False)
        noisy = ranges
        if self._noise is not None:
            noisy = np.clip(self._noise.apply(ranges), self.ray.near, self.ray.far)
        message = self._scan
        message.header.stamp = Time.from_nsec(self.site.now_ns)
        message.ranges = self._masked(ranges, noisy).astype(np.float32)
        message.intensities = intensities.astype(np.float32)
        return message

    def _retro(self, targets: NDArray[np.intp]) -> Floats:
        """`laserRetro` of what each beam hits; 0 of nothing, which is the last entry."""
        owners = self.site.world.targets
        known = np.array([*(owner.plan.retro for owner in owners), 0.0])
        found: Floats = known[targets]
        return found
