from __future__ import annotations

import math

import pytest

from simkit.msgs import Time
from simkit.viz.stage.frames import tf_scene

START = 1_600_088_400


def test_poses_are_lookups(turtles):
    scene = tf_scene(turtles, fixed_frame="turtle2")
    assert [pose.name for pose in scene.poses] == ["world", "turtle1", "carrot1", "turtle2"]
    assert [pose.parent for pose in scene.poses] == [None, "world", "turtle1", "world"]
    for pose in scene.poses:
        found = turtles.core.lookup("turtle2", pose.name)
        assert pose.origin == found.translation
        assert pose.rotation == pytest.approx(found.rotation)
    assert scene.error == ""
    assert scene.problems == ()


def test_axes_are_the_turned_unit_vectors(buffer):
    buffer.put("world", "a", rpy=(0, 0, math.pi / 2))
    (_, pose) = tf_scene(buffer, fixed_frame="world").poses
    x, y, z = pose.axes
    assert x == pytest.approx((0, 1, 0), abs=1e-12)
    assert y == pytest.approx((-1, 0, 0), abs=1e-12)
    assert z == pytest.approx((0, 0, 1), abs=1e-12)


def test_another_time(turtles):
    scene = tf_scene(turtles, fixed_frame="world", time=Time(START))
    poses = {pose.name: pose for pose in scene.poses}
    assert poses["turtle2"].origin == pytest.approx((3.0, 3.5, 0.0))


def test_an_unknown_fixed_frame_is_named_as_rviz_does(turtles):
    scene = tf_scene(turtles, fixed_frame="wrold")
    assert scene.poses == ()
    assert scene.error == (
        "Fixed Frame [wrold] does not exist. Did you mean [world]? "
        "Frames: [carrot1], [turtle1], [turtle2], [world]."
    )


def test_an_empty_buffer(buffer):
    assert tf_scene(buffer, fixed_frame="map").error == (
        "No tf data.  Actual error: Fixed Frame [map] does not exist"
    )


def test_frames_of_another_tree_are_listed(two_trees):
    scene = tf_scene(two_trees, fixed_frame="world")
    assert len(scene.poses) == 4
    assert scene.problems == tuple(
        f"No transform from [{name}] to [world]: they are in two trees."
        for name in ("map", "odom", "base_link", "laser")
    )


def test_frames_without_data_at_the_time_are_listed(two_trees):
    scene = tf_scene(two_trees, fixed_frame="map", time=Time(START))
    assert "No transform from [odom] to [map]: no data at that time." in scene.problems


def test_a_loop_is_a_problem_and_no_crash(buffer):
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a")):
        buffer.put(parent, child)
    buffer.put("world", "d")
    scene = tf_scene(buffer, fixed_frame="world")
    assert len(scene.problems) == 3
    assert all("loop" in problem for problem in scene.problems)


def test_frames_beyond_the_horizon_are_left_out(buffer):
    buffer.put("world", "far", xyz=(1e200, 0, 0))
    buffer.put("far", "farther", xyz=(1e308, 0, 0))
    scene = tf_scene(buffer, fixed_frame="world")
    assert [pose.name for pose in scene.poses] == ["world"]
    assert len(scene.problems) == 2
    assert scene.problems[0].endswith("it is too far away.")
