"""Gaussian noise on measurements, from a seed.

Source: Gazebo's `GaussianNoiseModel`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from simkit.plugins.sensor_tag import NoiseTag

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
