from __future__ import annotations

import pytest

from simkit.packages import PackagePath
from simkit.viz.robot_description import RobotDisplay, described_robot, robot_displays

ROBOT = '<robot name="r"><link name="a"><visual><geometry><sphere radius="1"/></geometry></visual></link></robot>'


def described(value, **options):
    return described_robot(value, PackagePath([]), **options)


def test_a_robot_is_read():
    robot = described(ROBOT, alpha=0.25)
    assert robot.errors == ()
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
    assert (robot.errors, robot.solids) == ((words,), ())


def test_a_broken_robot_is_told_in_one_line_with_its_place():
    robot = described(ROBOT.replace("</visual>", ""), name="/robot_description")
    assert robot.errors[0].startswith("URDF failed Model parse: /robot_description:1:")
    assert "\n" not in robot.errors[0]


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


def test_all_faults_of_a_robot_that_is_refused_are_told_each_in_a_line():
    joint = '<joint name="j{0}" type="{1}"><parent link="a"/><child link="b{0}"/></joint>'
    faulty = "\n".join(joint.format(number, "turns") for number in range(2))
    errors = described(ROBOT.replace("</robot>", f"{faulty}</robot>")).errors
    assert errors[0].startswith("URDF failed Model parse: /robot_description:1:")
    assert len(errors) == len(set(errors)) > 2
    assert all(error.startswith("/robot_description:") for error in errors[1:])
    assert not [error for error in errors if "\n" in error]
    many = "\n".join(joint.format(number, "turns") for number in range(40))
    errors = described(ROBOT.replace("</robot>", f"{many}</robot>")).errors
    assert len(errors) == 8
    assert errors[-1].endswith("more: simkit check_urdf shows them all.")


def test_a_prefix_stands_before_each_link():
    robot = described(ROBOT, tf_prefix="left")
    assert robot.links == ("left/a",)
    assert robot.solids[0].link == "left/a"


def test_which_robots_a_person_asks_for():
    assert robot_displays("/arm") == robot_displays(["/arm"]) == (RobotDisplay("/arm"),)
    assert robot_displays({"/l/arm": "/l/", "/r/arm": ""}) == (
        RobotDisplay("/l/arm", "l"),
        RobotDisplay("/r/arm", ""),
    )
