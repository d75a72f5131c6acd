"""Noise: its mean, its deviation, its offset, its steps, and that it is the same again."""

from __future__ import annotations

import numpy as np
import pytest

from simkit.plugins.noise import Noise
from simkit.plugins.sensor_tag import NoiseTag

ZEROS = np.zeros(40_000)


def test_mean_and_deviation():
    values = Noise(NoiseTag(mean=0.5, stddev=0.2), seed=1).apply(ZEROS)
    assert values.mean() == pytest.approx(0.5, abs=4 * 0.2 / 200)
    assert values.std() == pytest.approx(0.2, rel=0.02)


def test_an_offset_is_drawn_once_and_has_either_sign():
    offsets = [
        Noise(NoiseTag(bias_mean=1.0, bias_stddev=0.01), seed=seed).bias for seed in range(40)
    ]
    assert np.abs(offsets) == pytest.approx(1.0, abs=0.05)
    assert {np.sign(offset) for offset in offsets} == {-1.0, 1.0}
    noise = Noise(NoiseTag(bias_mean=1.0), seed=2)
    assert set(noise.apply(ZEROS)) == set(noise.apply(ZEROS)) == {noise.bias}


def test_values_are_multiples_of_the_precision():
    values = Noise(NoiseTag(stddev=1.0, precision=0.25), seed=3).apply(ZEROS)
    np.testing.assert_array_equal(values, np.round(values * 4) / 4)


def test_a_seed_repeats_it_and_so_does_a_new_beginning():
    noise = Noise(NoiseTag(stddev=1.0), seed=4)
    first = noise.apply(ZEROS)
    assert not np.array_equal(noise.apply(ZEROS), first)
    noise.restart()
    np.testing.assert_array_equal(noise.apply(ZEROS), first)
    np.testing.assert_array_equal(Noise(NoiseTag(stddev=1.0), seed=4).apply(ZEROS), first)
