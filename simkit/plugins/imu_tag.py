"""The tag `<imu>` of a sensor: the noise of each axis.

Source: SDF 1.5 and 1.6, `imu.sdf`.
"""

from __future__ import annotations

import numpy as np

from simkit.geometry import Vector
from simkit.plugins.noise import Noise
from simkit.plugins.sensor_tag import SensorTag, read_noise, warn_of_strangers
from simkit.plugins.site import Site

_READ = ("angular_velocity", "linear_acceleration", "topic", "noise", "orientation_reference_frame")


class AxisNoise:
    """Noise on the three axes of one quantity.

    Args:
        site: Where the plugin works.
        sensor: The sensor.
        quantity: `angular_velocity` or `linear_acceleration`.

    Raises:
        PluginError: A value makes no sense.
    """

    def __init__(self, site: Site, sensor: SensorTag, quantity: str) -> None:
        imu = sensor.element.child("imu")
        if imu is not None:
            warn_of_strangers(site, imu, _READ)
        element = None if imu is None else imu.child(quantity)
        self._noises: list[Noise | None] = []
        for axis in "xyz":
            tag = read_noise(site, None if element is None else element.child(axis))
            seed = site.seed("imu", sensor.name, quantity, axis)
            self._noises.append(None if tag is None else Noise(tag, seed))

    def apply(self, vector: Vector) -> Vector:
        """A measurement with noise."""
        x, y, z = (
            value if noise is None else float(noise.apply(np.array([value]))[0])
            for value, noise in zip(vector, self._noises, strict=True)
        )
        return (x, y, z)

    def restart(self) -> None:
        """The same noise again."""
        for noise in self._noises:
            if noise is not None:
                noise.restart()
