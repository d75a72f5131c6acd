"""Robots of a submission, and what a check says of their faults."""

from types import SimpleNamespace

import pytest

from grader.checks.robots import RobotFiles, link_of, only_visual
from grader.errors import CheckFailed
from grader.submission import Submission
from simkit.diagnostics import Severity

PATH = "hello_ros/urdf/post.urdf"
POST = """<robot name="post">
  <link name="post">
    <visual><geometry><box size="1 1 1"/></geometry></visual>
  </link>
</robot>
"""


def files(tmp_path, text=POST):
    submission = Submission(student="s", exercise_id="3.6", files={PATH: text}, answers={})
    exercise = SimpleNamespace(files=(PATH,))
    return RobotFiles(exercise, submission, tmp_path)


def test_a_good_robot(tmp_path):
    robots = files(tmp_path)
    robots.expect_clean("post.urdf")
    robot = robots.robot("post.urdf")
    assert robot.root == "post"
    assert robots.text("post.urdf") == POST
    assert only_visual(robot, "post").geometry.size == (1.0, 1.0, 1.0)


def test_a_refused_robot_is_told_with_its_place_and_the_remedy(tmp_path):
    robots = files(tmp_path, POST.replace("</link>", ""))
    for look in (robots.robot, robots.expect_clean):
        with pytest.raises(CheckFailed) as caught:
            look("post.urdf")
        assert str(caught.value).startswith(f"{PATH}:2:")
        assert caught.value.hint


def test_a_warning_can_be_let_through(tmp_path):
    robots = files(tmp_path, POST.replace("<visual>", "<visual><pose>0 0 1 0 0 0</pose>"))
    with pytest.raises(CheckFailed, match="pose"):
        robots.expect_clean("post.urdf")
    robots.expect_clean("post.urdf", severity=Severity.ERROR)


def test_a_file_that_was_not_handed_in(tmp_path):
    with pytest.raises(CheckFailed, match="was not handed in"):
        files(tmp_path).robot("arm.urdf")


def test_links_and_visuals_that_are_missing(tmp_path):
    robot = files(tmp_path).robot("post.urdf")
    with pytest.raises(CheckFailed, match="no link pole"):
        link_of(robot, "pole")
    bare = files(tmp_path, '<robot name="r"><link name="post"/></robot>').robot("post.urdf")
    with pytest.raises(CheckFailed, match="nothing is to be seen"):
        only_visual(bare, "post")
