from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.msgs import message_class
from simkit.viz.scene_style import rgb
from simkit.viz.topics.laser_points import laser_points, rainbow

INF, NAN = math.inf, math.nan


def scan(*ranges, **fields):
    message = message_class("sensor_msgs/LaserScan")()
    message.angle_min, message.angle_increment = -math.pi / 2, math.pi / 4
    message.range_min, message.range_max = 0.5, 10.5
    message.ranges = list(ranges)
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def test_beams_are_counted_counter_clockwise_from_the_first_angle():
    points, _ = laser_points(scan(1.0, 2.0, 3.0, 2.0, 1.0))
    r = math.sqrt(2.0)
    expected = [(0, -1, 0), (r, -r, 0), (3, 0, 0), (r, r, 0), (0, 1, 0)]
    assert points == pytest.approx(np.array(expected, float), abs=1e-12)


def test_only_ranges_within_the_range_are_points():
    points, colors = laser_points(scan(0.49, 0.5, 10.5, INF, -INF, NAN, 10.4))
    assert np.hypot(points[:, 0], points[:, 1]) == pytest.approx([0.5, 10.4])
    assert len(colors) == 2


def test_near_is_red_and_far_is_violet():
    near, middle, far = (rgb(color) for color in laser_points(scan(0.5, 5.5, 10.49))[1])
    assert near == (1.0, 0.0, 0.0)
    assert far == pytest.approx((1.0, 0.0, 1.0), abs=0.01)
    assert middle[1] > 0.9
    assert middle[0] < 0.1


def test_all_points_may_have_one_colour():
    assert list(laser_points(scan(1.0, 9.0), (0.0, 0.0, 1.0))[1]) == ["#0000ff", "#0000ff"]


@pytest.mark.parametrize("range_max", [0.5, 0.1, INF])
def test_a_range_that_is_none_has_colours_all_the_same(range_max):
    _, colors = laser_points(scan(1.0, range_max=range_max))
    assert all(color.startswith("#") for color in colors)


def test_a_scan_without_beams_has_no_points():
    points, colors = laser_points(scan())
    assert points.shape == (0, 3)
    assert len(colors) == 0


def test_a_rainbow_is_of_strong_colours_only():
    for color in rainbow(np.linspace(0, 1, 50)):
        assert max(rgb(color)) == 1.0
        assert min(rgb(color)) == 0.0
