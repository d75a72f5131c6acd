from __future__ import annotations

import math

import pytest

from simkit.geometry import IDENTITY, Transform
from simkit.msgs import message_class
from simkit.viz.topics.displays import LaserScanDisplay, OdometryDisplay, PathDisplay
from simkit.viz.topics.topic_marks import arrow_line, display_marks, path_shown, scan_shown

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
