from __future__ import annotations

import itertools
import math
from dataclasses import replace

import pytest

from simkit.geometry import rotate
from simkit.viz.stage.camera import on_paper
from simkit.viz.stage.parts import Role
from simkit.viz.stage.robot import RobotShapes
from simkit.viz.stage.scene import Displays, corners, make_scene
from simkit.viz.stage.style import LOST_ALPHA


def by_link(scene, role=Role.VISUAL):
    return {placed.solid.link: placed for placed in scene.solids if placed.solid.role is role}


def test_links_are_where_tf_says_and_not_where_the_robot_would_put_them(arm_frames, arm):
    arm_frames.put("base_link", "torso", 1_600_088_401, (7, 8, 9))
    torso = by_link(make_scene(arm_frames, fixed_frame="world", robot=arm))["torso"]
    assert torso.pose()[0] == pytest.approx((7, 8, 9.25))


def test_shapes_are_turned_with_their_link(arm_frames, arm):
    placed = by_link(make_scene(arm_frames, fixed_frame="world", robot=arm))["upper_arm"]
    origin, turn = placed.pose()
    # At these angles the upper arm points along x of the torso, which is turned by half a radian.
    along = (math.cos(0.5), math.sin(0.5), 0)
    assert rotate(turn, (0, 0, 1)) == pytest.approx(along, abs=1e-9)
    foot = (0.1 * math.sin(0.5), -0.1 * math.cos(0.5), 0.5)
    assert origin == pytest.approx([f + 0.2 * a for f, a in zip(foot, along, strict=True)])


def test_the_same_robot_seen_from_its_torso(arm_frames, arm):
    scene = make_scene(arm_frames, fixed_frame="torso", robot=arm)
    assert by_link(scene)["torso"].pose()[0] == pytest.approx((0, 0, 0.25))
    assert not any(placed.is_lost for placed in scene.solids)
    assert scene.problems == ()


def test_links_that_tf_does_not_know_are_white_at_the_origin_and_named(buffer, arm):
    buffer.put("world", "base_link", static=True)
    scene = make_scene(buffer, fixed_frame="world", robot=arm)
    assert scene.tf.error == ""
    assert scene.problems == (
        "No transform from [torso] to [world]: no node broadcasts this link.",
        "No transform from [upper_arm] to [world]: no node broadcasts this link.",
    )
    assert scene.notes == ("Links without a transform are white and at the origin, as in RViz.",)
    placed = by_link(scene)
    assert not placed["base_link"].is_lost
    assert placed["torso"].is_lost
    assert placed["torso"].color == (1, 1, 1)
    assert placed["torso"].alpha == LOST_ALPHA
    assert placed["torso"].pose()[0] == (0, 0, 0.25)


def test_without_any_tf_only_the_link_that_is_the_fixed_frame_is_known(buffer, arm):
    scene = make_scene(buffer, fixed_frame="torso", robot=arm)
    assert scene.tf.error == "No tf data.  Actual error: Fixed Frame [torso] does not exist"
    lost = {link for link, placed in by_link(scene).items() if placed.is_lost}
    assert lost == {"base_link", "upper_arm"}
    assert scene.problems == tuple(
        f"No transform from [{link}] to [torso]" for link in ("world", "base_link", "upper_arm")
    )


def test_a_link_in_another_tree_is_named_once(arm_frames, arm):
    arm_frames.put("map", "odom")
    scene = make_scene(arm_frames, fixed_frame="map", robot=arm)
    links = ("world", "base_link", "torso", "upper_arm")
    assert scene.problems == tuple(
        f"No transform from [{link}] to [map]: they are in two trees." for link in links
    )


def test_why_there_is_no_robot_is_a_problem(turtles):
    scene = make_scene(turtles, fixed_frame="world", robot=RobotShapes(errors=("URDF is empty",)))
    assert scene.problems == ("URDF is empty",)
    assert scene.solids == ()


def test_without_a_robot_model_there_are_no_shapes(arm_frames, arm):
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm, displays=Displays(robot=None))
    assert scene.solids == ()


def test_the_camera_sees_the_whole_robot(arm_frames, arm):
    scene = make_scene(arm_frames, fixed_frame="world", robot=arm)
    size = (720.0, 450.0)
    for placed in scene.solids:
        for corner in corners(placed.solid, placed.frame):
            x, y = on_paper(scene.stage.camera.seen(corner), size)
            assert 0 <= x <= size[0]
            assert 0 <= y <= size[1]


def test_the_camera_sees_the_room_of_a_robot_where_its_root_stands(arm_frames, arm):
    arm_frames.put("map", "world", static=True, xyz=(5, 0, 0))
    scene = make_scene(arm_frames, fixed_frame="map", robot=arm, room={"world": [(0, 0, 3)]})
    x, y = on_paper(scene.stage.camera.seen((5, 0, 3)), (720.0, 450.0))
    assert 0 <= x <= 720
    assert 0 <= y <= 450


def test_corners_are_those_of_the_box_around_a_shape(arm):
    (base,) = [s for s in arm.solids if s.link == "base_link"]
    assert {tuple(round(v, 9) for v in corner) for corner in corners(base, None)} == set(
        itertools.product((-0.1, 0.1), (-0.1, 0.1), (0.0, 0.05))
    )


def test_a_robot_whose_prefix_was_forgotten_is_told_so(buffer, arm):
    buffer.put("world", "left/torso", static=True)
    (problem,) = [
        p for p in make_scene(buffer, fixed_frame="world", robot=arm).problems if "torso" in p
    ]
    assert problem == (
        "No transform from [torso] to [world]: no node broadcasts this link, "
        "but there is [left/torso]: the TF Prefix 'left' may be missing."
    )


def test_a_robot_without_shapes_of_the_kind_that_is_shown_is_no_riddle(arm_frames, arm):
    def notes(robot):
        displays = Displays(robot=Role.COLLISION)
        return make_scene(arm_frames, fixed_frame="world", robot=robot, displays=displays).notes

    assert notes(arm) == ()
    bare = replace(arm, solids=tuple(s for s in arm.solids if s.role is Role.VISUAL))
    assert notes(bare) == ("The robot has no collision shapes, only visual ones.",)
