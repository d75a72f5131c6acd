from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.geometry import IDENTITY, Transform
from simkit.msgs import message_class
from simkit.viz.stage.rviz_settings import LaserScanDisplay, OdometryDisplay, PathDisplay
from simkit.viz.stage.style import rgb
from simkit.viz.stage.topic_marks import (
    arrow_line,
    display_marks,
    laser_points,
    path_shown,
    rainbow,
    scan_shown,
)

HERE = Transform()
QUARTER = Transform((1.0, 0.0, 0.0), (0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))


def path(*points):
    message = message_class("nav_msgs/Path")()
    for x, y, z in points:
        pose = message_class("geometry_msgs/PoseStamped")()
        pose.pose.position.x, pose.pose.position.y, pose.pose.position.z = x, y, z
        message.poses.append(pose)
    return message


def scan(*ranges):
    return message_class("sensor_msgs/LaserScan")(range_max=1e15, ranges=list(ranges))


def test_a_path_is_moved_and_turned_with_its_frame():
    (line,) = path_shown(path((1, 0, 0), (2, 0, 5)), QUARTER).lines
    assert line == (pytest.approx((1, 1, 0)), pytest.approx((1, 2, 5)))


def test_what_is_too_far_away_is_left_out():
    assert path_shown(path((1e13, 0, 0), (math.inf, 0, 0), (math.nan, 0, 0)), HERE).lines == ()
    shown = scan_shown(LaserScanDisplay(topic="/scan"), scan(1.0, 1e13), HERE)
    assert len(shown.points) == len(shown.colors) == 1


def test_an_arrow_is_as_long_as_its_display_says():
    line = arrow_line(OdometryDisplay(topic="/odom", length=2.0), (1.0, 1.0, 1.0), IDENTITY)
    tail, tip, left, right, end = line
    assert tail == (1, 1, 1)
    assert tip == end == (3, 1, 1)
    assert left[1] > 1 > right[1]


@pytest.mark.parametrize(
    "display",
    [LaserScanDisplay(topic="/s"), PathDisplay(topic="/s"), OdometryDisplay(topic="/s")],
)
def test_each_display_has_marks_with_a_name_and_a_colour(display):
    shown = scan_shown(LaserScanDisplay(topic="/s"), scan(1.0, 2.0), HERE)
    marks = display_marks(display, 3, shown)
    assert marks.name == "topic-3"
    assert marks.label == f"{display.kind} /s"
    assert marks.color.startswith("#")
    assert len(marks.points) == len(marks.colors) == 2


def test_a_long_name_is_shortened_at_its_checkbox():
    marks = display_marks(PathDisplay(topic="/" + "x" * 500), 0, path_shown(path(), HERE))
    assert len(marks.label) < 40


INF, NAN = math.inf, math.nan


def scan_laser_points(*ranges, **fields):
    message = message_class("sensor_msgs/LaserScan")()
    message.angle_min, message.angle_increment = -math.pi / 2, math.pi / 4
    message.range_min, message.range_max = 0.5, 10.5
    message.ranges = list(ranges)
    for name, value in fields.items():
        setattr(message, name, value)
    return message


def test_beams_are_counted_counter_clockwise_from_the_first_angle():
    points, _ = laser_points(scan_laser_points(1.0, 2.0, 3.0, 2.0, 1.0))
    r = math.sqrt(2.0)
    expected = [(0, -1, 0), (r, -r, 0), (3, 0, 0), (r, r, 0), (0, 1, 0)]
    assert points == pytest.approx(np.array(expected, float), abs=1e-12)


def test_only_ranges_within_the_range_are_points():
    points, colors = laser_points(scan_laser_points(0.49, 0.5, 10.5, INF, -INF, NAN, 10.4))
    assert np.hypot(points[:, 0], points[:, 1]) == pytest.approx([0.5, 10.4])
    assert len(colors) == 2


def test_near_is_red_and_far_is_violet():
    near, middle, far = (
        rgb(color) for color in laser_points(scan_laser_points(0.5, 5.5, 10.49))[1]
    )
    assert near == (1.0, 0.0, 0.0)
    assert far == pytest.approx((1.0, 0.0, 1.0), abs=0.01)
    assert middle[1] > 0.9
    assert middle[0] < 0.1


def test_all_points_may_have_one_colour():
    assert list(laser_points(scan_laser_points(1.0, 9.0), (0.0, 0.0, 1.0))[1]) == [
        "#0000ff",
        "#0000ff",
    ]


@pytest.mark.parametrize("range_max", [0.5, 0.1, INF])
def test_a_range_that_is_none_has_colours_all_the_same(range_max):
    _, colors = laser_points(scan_laser_points(1.0, range_max=range_max))
    assert all(color.startswith("#") for color in colors)


def test_a_scan_without_beams_has_no_points():
    points, colors = laser_points(scan_laser_points())
    assert points.shape == (0, 3)
    assert len(colors) == 0


def test_a_rainbow_is_of_strong_colours_only():
    for color in rainbow(np.linspace(0, 1, 50)):
        assert max(rgb(color)) == 1.0
        assert min(rgb(color)) == 0.0
