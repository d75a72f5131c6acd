"""The robot as it stands when it is spawned: in the floor, in itself; and right angles."""

from __future__ import annotations

import time

import pytest

from simkit.diagnostics import Severity

BALL = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
BOX = '<collision><geometry><box size="0.5 0.3 0.07"/></geometry></collision>'
WHEEL = '<collision><origin rpy="1.570796 0 0"/><geometry><cylinder radius="0.1" length="0.04"/></geometry></collision>'


def link(name, inside=BALL):
    return f'<link name="{name}">{inside}</link>\n'


def joint(parent, child, xyz="0 0 0", kind="fixed", rpy="0 0 0"):
    return (
        f'<joint name="{child}_joint" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 1 0"/></joint>'
    )


def spawn(args):
    return f'<launch><node name="s" pkg="gazebo_ros" type="spawn_model" args="{args}"/></launch>'


def test_what_hangs_below_the_root_is_in_the_floor(told):
    text = (
        link("base", "")
        + link("high")
        + link("low")
        + joint("base", "high", "0 0 0.05")
        + joint("high", "low", "0 0 -0.1")
    )
    (one,) = told(text, "GZ-W06")
    assert (one.severity, one.span.line) == (Severity.NOTE, 4)
    assert "0.15 m below its root link" in one.what
    assert one.remedy == "Spawn it with -z 0.15 or more."


def test_turned_shapes_are_measured_as_they_stand(told):
    pole = '<collision><geometry><cylinder radius="0.01" length="1"/></geometry></collision>'
    (one,) = told(
        link("base", "") + link("a", pole) + joint("base", "a", "0 0 0.2", rpy="1.0471976 0 0"),
        "GZ-W06",
    )
    assert "-z 0.059" in one.remedy  # 0.5 cos 60° + 0.01 sin 60° - 0.2


@pytest.mark.parametrize(
    "text",
    [
        link("base", "") + link("low") + joint("base", "low", "0 0 0.1"),
        link("world", "") + link("low") + joint("world", "low"),
        link("base", '<visual><geometry><sphere radius="1"/></geometry></visual>'),
    ],
    ids=["on the floor", "fixed to the world", "touches nothing"],
)
def test_robots_that_stand_well(told, text):
    assert told(text, "GZ-W06") == []


@pytest.mark.parametrize(
    ("args", "words"),
    [
        ("-urdf -param robot_description -model r -z 0.1", None),
        (
            "-urdf -param robot_description -model r -z 0.05",
            "the launch file spawns it at z = 0.05",
        ),
        ("-urdf -param robot_description -model r", "the launch file spawns it at z = 0"),
        ("-urdf -model r -z $(arg z)", "0.1 m below"),
    ],
)
def test_the_launch_file_says_how_high_it_is_spawned(told, args, words):
    found = told(link("base"), "GZ-W06", launch=spawn(args))
    assert [words in one.what for one in found] == ([] if words is None else [True])


def test_links_that_no_joint_connects_reach_into_each_other(told):
    arm = (
        link("a")
        + link("b")
        + link("c")
        + joint("a", "b", "0.15 0 0", "revolute")
        + joint("b", "c", "-0.05 0 0", "revolute")
    )
    (one,) = told(arm, "URDF-I44")
    assert (one.severity, one.span.line) == (Severity.NOTE, 4)
    assert one.what.endswith("'a' and 'c'")
    assert told(arm.replace("-0.05 0 0", "0.15 0 0"), "URDF-I44") == []


def test_links_that_are_fixed_to_each_other_or_joined_may_overlap(told):
    arm = (
        link("a")
        + link("b")
        + link("c")
        + joint("a", "b", "0 0 0.01")
        + joint("b", "c", "0 0 0.01", "continuous")
    )
    assert told(arm, "URDF-I44") == []


def test_a_wheel_in_the_body(told):
    car = link("body", BOX) + link("wheel", WHEEL)
    (one,) = told(car + joint("body", "wheel", "0 0.15 0", "continuous"), "URDF-I44")
    assert "a wheel reaches into the body: 'body' and 'wheel'" in one.what
    assert told(car + joint("body", "wheel", "0 0.17 0", "continuous"), "URDF-I44") == []
    elbow = joint("body", "wheel", "0 0.15 0", "continuous").replace('xyz="0 1 0"', 'xyz="0 0 1"')
    assert told(car + elbow, "URDF-I44") == []


def test_many_balls_in_one_place_take_no_time(told):
    text = "".join(link(f"b{i}") for i in range(300))
    text += "".join(joint("b0", f"b{i}", kind="continuous") for i in range(1, 300))
    start = time.process_time()
    told(text, "URDF-I44")
    assert time.process_time() - start < 5.0


@pytest.mark.parametrize(
    ("angle", "words"), [("1.57", "90° by 0.04563°"), ("-1.5707", "-90° by"), ("3.14", "180° by")]
)
def test_right_angles_with_too_few_digits(told, angle, words):
    text = (
        link("a")
        + link("b")
        + joint("a", "b", rpy=f"{angle} 0 0")
        + joint("b", "c", rpy=f"0 {angle} 0")
    )
    (one,) = told(text, "URDF-I46")
    assert one.severity is Severity.NOTE
    assert one.source[one.span.column - 1 :].startswith(angle)
    assert words in one.what
    assert "and 1 more" in one.what


@pytest.mark.parametrize("angle", ["1.5708", "1.570796", "0.001", "1.2", "3.1416", "4.712389"])
def test_angles_that_may_be_so(told, angle):
    assert told(link("a") + link("b") + joint("a", "b", rpy=f"{angle} 0 0"), "URDF-I46") == []


def test_a_namespace_that_nothing_uses(told):
    wrong = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/></robot>'
    (one,) = told(wrong, "URDF-I48")
    assert one.source[one.span.column - 1 :].startswith("xmlns:xacro")
    assert told('<robot name="r"><link name="a"/></robot>', "URDF-I48") == []
    used = '<robot name="r" xmlns:my="http://x"><link name="a"/><my:note/></robot>'
    assert told(used, "URDF-I48") == []
