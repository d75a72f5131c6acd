"""The beams of a laser: where they go, and what is told between them."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.plugins.beams import ONE_ROW, RayTag, Row, directions, resampled


def rays(flat: Row, upright: Row = ONE_ROW) -> RayTag:
    return RayTag(flat=flat, upright=upright, near=0.1, far=10.0, noise=None)


def test_the_beams_of_the_book_are_half_a_turn_in_719_steps():
    row = Row(samples=720, min_angle=-1.570796, max_angle=1.570796)
    assert row.count == 720
    assert row.step == pytest.approx(3.141592 / 719, rel=1e-12)
    ways = directions(rays(row))
    angles = np.arctan2(ways[:, 1], ways[:, 0])
    np.testing.assert_allclose(np.diff(angles), row.step, atol=1e-12)
    assert angles[0] == pytest.approx(-1.570796)
    np.testing.assert_allclose(np.linalg.norm(ways, axis=1), 1.0, atol=1e-12)


def test_a_single_beam_goes_straight_ahead_whatever_its_angles():
    row = Row(samples=1, min_angle=0.5, max_angle=1.0)
    assert row.step == 0.0
    np.testing.assert_array_equal(directions(rays(row)), [[1.0, 0.0, 0.0]])


def test_rows_go_from_below_to_above():
    upright = Row(samples=3, min_angle=-0.5, max_angle=0.5)
    ways = directions(rays(Row(samples=2, min_angle=-0.1, max_angle=0.1), upright))
    np.testing.assert_allclose(ways[:, 2], np.repeat(np.sin([-0.5, 0.0, 0.5]), 2), atol=1e-12)
    assert math.atan2(ways[0, 1], ways[0, 0]) == pytest.approx(-0.1)


@pytest.mark.parametrize(("resolution", "count"), [(2.0, 6), (0.7, 2), (1.0, 3)])
def test_ranges_lie_on_the_line_through_the_beams(resolution, count):
    tag = rays(Row(samples=3, resolution=resolution, min_angle=0.0, max_angle=1.0))
    told = resampled(tag, np.array([1.0, 2.0, 4.0]), blend=True)
    expected = np.interp(np.linspace(0, 2, count), [0, 1, 2], [1.0, 2.0, 4.0])
    np.testing.assert_allclose(told, expected)


def test_between_rows_all_four_beams_count():
    upright = Row(samples=2, resolution=1.5, min_angle=0.0, max_angle=1.0)
    tag = rays(Row(samples=2, resolution=1.5, min_angle=0.0, max_angle=1.0), upright)
    told = resampled(tag, np.array([1.0, 2.0, 3.0, 4.0]), blend=True)
    np.testing.assert_allclose(told, [1.0, 1.5, 2.0, 2.0, 2.5, 3.0, 3.0, 3.5, 4.0])
    means = resampled(tag, np.array([0.0, 0.0, 0.0, 40.0]), blend=False)
    np.testing.assert_allclose(means, [10, 10, 20, 10, 10, 20, 20, 20, 40])
