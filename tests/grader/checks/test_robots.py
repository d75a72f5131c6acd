"""Robots of a submission, and what a check says of their faults."""

from types import SimpleNamespace

import pytest

from grader.checks.robots import (
    RobotFiles,
    cylinder_of,
    expect_chain,
    expect_firm,
    expect_silver_cylinder,
    joints_above,
    link_of,
    only_visual,
    slider_of,
)
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
    with pytest.raises(CheckFailed, match="post is invisible"):
        only_visual(bare, "post")


ARM = """<robot name="arm">
  <material name="silver"><color rgba="0.75 0.75 0.75 1"/></material>
  <link name="world"/>
  <link name="arm">
    <visual>
      <geometry><cylinder length="0.4" radius="0.05"/></geometry><material name="silver"/>
    </visual>
  </link>
  <joint name="j" type="fixed"><parent link="world"/><child link="arm"/></joint>
</robot>
"""


def test_a_chain_and_a_silver_cylinder(tmp_path):
    robot = files(tmp_path, ARM).robot("post.urdf")
    expect_chain(robot, "world", "arm")
    expect_silver_cylinder(robot, "arm", length=0.4, radius=0.05)
    with pytest.raises(CheckFailed, match="root of the tree"):
        expect_chain(robot, "arm", "world")
    with pytest.raises(CheckFailed, match="no link hand"):
        expect_chain(robot, "world", "arm", "hand")
    with pytest.raises(CheckFailed, match="ength and radius of arm"):
        expect_silver_cylinder(robot, "arm", length=0.05, radius=0.4)


def test_links_in_between_do_not_break_a_chain(tmp_path):
    longer = ARM.replace(
        '<joint name="j" type="fixed"><parent link="world"/>',
        '<link name="footprint"/><joint name="i" type="fixed"><parent link="world"/>'
        '<child link="footprint"/></joint><joint name="j" type="fixed"><parent link="footprint"/>',
    )
    robot = files(tmp_path, longer).robot("post.urdf")
    expect_chain(robot, "world", "arm")
    expect_chain(robot, "world", "footprint", "arm")
    assert [joint.name for joint in joints_above(robot, "arm")] == ["j", "i"]
    with pytest.raises(CheckFailed, match="he parent of footprint"):
        expect_chain(robot, "world", "arm", "footprint")


def test_links_in_a_ring_end(tmp_path):
    ring = ARM.replace(
        "</robot>",
        '<link name="a"/><link name="b"/>'
        '<joint name="ab" type="fixed"><parent link="a"/><child link="b"/></joint>'
        '<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint></robot>',
    )
    robot = files(tmp_path, ring).robot("post.urdf")
    assert [joint.name for joint in joints_above(robot, "a")] == ["ba", "ab"]


def test_a_very_long_robot_is_climbed_as_well(tmp_path):
    count = 5000
    text = "".join(f'<link name="l{number}"/>' for number in range(count)) + "".join(
        f'<joint name="j{number}" type="fixed"><parent link="l{number}"/><child link="l{number + 1}"/></joint>'
        for number in range(count - 1)
    )
    robot = files(tmp_path, f'<robot name="long">{text}</robot>').robot("post.urdf")
    assert len(joints_above(robot, f"l{count - 1}")) == count - 1


def test_a_link_that_can_move_is_not_firm(tmp_path):
    expect_firm(files(tmp_path, ARM).robot("post.urdf"), "arm")
    moving = ARM.replace('type="fixed">', 'type="continuous"><axis xyz="0 0 1"/>')
    with pytest.raises(CheckFailed, match="arm can move: the joint j above it is continuous"):
        expect_firm(files(tmp_path, moving).robot("post.urdf"), "arm")


def test_a_mark_beside_the_cylinder_is_let_be_and_a_second_cylinder_is_not(tmp_path):
    marked = ARM.replace(
        "</link>\n  <joint",
        '<visual><geometry><sphere radius="0.1"/></geometry></visual></link>\n  <joint',
    )
    robot = files(tmp_path, marked).robot("post.urdf")
    visual, shape = cylinder_of(robot, "arm")
    assert len(robot.links["arm"].visuals) == 2
    assert visual.geometry is shape
    assert shape.length == 0.4
    twice = marked.replace('<sphere radius="0.1"/>', '<cylinder length="1" radius="1"/>')
    with pytest.raises(CheckFailed, match="arm is 2 cylinders"):
        cylinder_of(files(tmp_path, twice).robot("post.urdf"), "arm")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('<cylinder length="0.4" radius="0.05"/>', '<sphere radius="1"/>', "arm is a sphere"),
        ("0.75 0.75 0.75 1", "1 0 0 1", "he colour of arm"),
        ('</geometry><material name="silver"/>', "</geometry>", "he colour of arm"),
    ],
)
def test_another_shape_or_colour(tmp_path, old, new, words):
    robot = files(tmp_path, ARM.replace(old, new)).robot("post.urdf")
    with pytest.raises(CheckFailed, match=words):
        expect_silver_cylinder(robot, "arm", length=0.4, radius=0.05)


def test_the_sliders_of_a_launch():
    gui = SimpleNamespace(set_position=print)
    nodes = {"/a": SimpleNamespace(), "/b": SimpleNamespace(program=gui)}
    assert slider_of(SimpleNamespace(nodes=nodes)) is gui
    with pytest.raises(CheckFailed, match="there is no slider"):
        slider_of(SimpleNamespace(nodes={}))
