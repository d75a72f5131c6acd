from __future__ import annotations

import pytest

from simkit.packages import PackagePath
from simkit.viz.robot_description import described_robot

ROBOT = '<robot name="r"><link name="a"><visual><geometry><sphere radius="1"/></geometry></visual></link></robot>'


def described(value, **options):
    return described_robot(value, PackagePath([]), **options)


def test_a_robot_is_read():
    robot = described(ROBOT, alpha=0.25)
    assert robot.error == ""
    assert robot.links == ("a",)
    assert [solid.alpha for solid in robot.solids] == [0.25]


def test_no_robot_under_the_usual_name_is_nothing_to_speak_of():
    assert described(None) is None


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, "Parameter [/arm] does not exist, and was not found by searchParam()"),
        (42, "Parameter [/arm] is no text: it should hold the URDF of a robot"),
        (" \n", "URDF is empty"),
    ],
)
def test_what_is_wrong_is_said_as_rviz_says_it(value, words):
    robot = described(value, name="/arm")
    assert (robot.error, robot.solids) == (words, ())


def test_a_broken_robot_is_told_in_one_line_with_its_place():
    robot = described(ROBOT.replace("</visual>", ""), name="/robot_description")
    assert robot.error.startswith("URDF failed Model parse: /robot_description:1:")
    assert "\n" not in robot.error


def test_meshes_are_found_in_packages(tmp_path):
    (tmp_path / "hello_ros").mkdir()
    (tmp_path / "hello_ros/package.xml").write_text("<package/>")
    mesh = '<mesh filename="package://hello_ros/hand.obj"/>'
    text = ROBOT.replace('<sphere radius="1"/>', mesh)
    packages = PackagePath([tmp_path])
    assert len(described_robot(text, packages).notes) == 1
    (tmp_path / "hello_ros/hand.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    robot = described_robot(text, packages)
    assert robot.notes == ()
    assert robot.solids[0].shape.high == (1, 1, 0)
