"""Noise of sensors: what its tags say, and its generators."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from simkit.geometry import Vector
from simkit.plugins.sensor_tag import NoiseTag, SensorTag, read_noise, warn_of_strangers
from simkit.plugins.site import Site

Floats = NDArray[np.float64]


def generator(seed: int) -> np.random.Generator:
    """A generator of random numbers."""
    return np.random.Generator(np.random.PCG64(seed))


class Noise:
    """Noise of one kind.

    Args:
        tag: What it is like.
        seed: Where its random numbers begin.
    """

    def __init__(self, tag: NoiseTag, seed: int) -> None:
        self.tag = tag
        self._seed = seed
        self.restart()

    def restart(self) -> None:
        """Begin anew: the same numbers again."""
        self._random = generator(self._seed)
        bias = float(self._random.normal(self.tag.bias_mean, self.tag.bias_stddev))
        self.bias = bias if self._random.random() < 0.5 else -bias

    def apply(self, values: Floats) -> Floats:
        """Values with noise on each of them."""
        tag = self.tag
        noisy = values + self.bias + self._random.normal(tag.mean, tag.stddev, values.shape)
        if tag.precision > 0.0:
            noisy = np.round(noisy / tag.precision) * tag.precision
        return noisy


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
