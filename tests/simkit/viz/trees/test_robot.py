from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from simkit.errors import UnknownNameError
from simkit.urdf import load_robot
from simkit.viz import RobotTree
from simkit.viz.trees.robot import robot_nodes

SVG = "{http://www.w3.org/2000/svg}"


def robot_of(links, *joints):
    text = "".join(f'<link name="{name}"/>' for name in links)
    for name, type_, parent, child, *inner in joints:
        text += f'<joint name="{name}" type="{type_}"><parent link="{parent}"/>'
        text += f'<child link="{child}"/>{"".join(inner)}</joint>'
    return load_robot(f'<robot name="r">{text}</robot>', file="r.urdf")


@pytest.fixture
def gripper():
    limit = '<limit lower="-0.5" upper="1" effort="1" velocity="1"/>'
    return robot_of(
        ["base", "arm", "finger", "thumb"],
        ("lift", "prismatic", "base", "arm", limit, '<axis xyz="0 0 -1"/>'),
        ("curl", "revolute", "arm", "finger", limit, '<origin xyz="1 0 0" rpy="0 0 0.3"/>'),
        ("nip", "revolute", "arm", "thumb", limit, '<mimic joint="curl" multiplier="-2" offset="-1"/>'),
    )  # fmt: skip


def test_links_joints_and_their_facts(gripper, texts):
    shown = texts(RobotTree(gripper).to_svg())
    assert shown[:2] == ["r", "4 links, 3 joints (3 move)"]
    assert {"base", "arm", "finger", "thumb", "lift", "curl", "nip"} <= set(shown)
    assert {"prismatic", "-z", "-0.5 to 1 m", "-0.5 to 1 rad", "0 0 0.3 rad", "1 0 0 m"} <= set(
        shown
    )
    assert "-2 * curl - 1" in shown


def test_fixed_joints_are_broken_lines_with_a_key(gripper, texts):
    fixed = robot_of("ab", ("j", "fixed", "a", "b"))
    assert "stroke-dasharray" in RobotTree(fixed).to_svg()
    assert "broken line: a fixed joint" in texts(RobotTree(fixed).to_svg())
    assert "stroke-dasharray" not in RobotTree(gripper).to_svg()


def test_a_link_that_hangs_on_two_joints_is_drawn_twice_and_grows_once():
    robot = robot_of(
        "abcd",
        ("j", "fixed", "a", "b"),
        ("k", "fixed", "a", "c"),
        ("l", "fixed", "b", "c"),
        ("m", "fixed", "c", "d"),
    )
    nodes = robot_nodes(robot)
    assert [(node.name, node.is_echo) for node in nodes] == [
        ("a", False),
        ("b", False),
        ("c", False),
        ("d", False),
        ("c", True),
    ]


def test_a_wide_robot_grows_sideways_and_stays_on_the_page():
    robot = robot_of(
        ["hub", *(f"spoke_{number}" for number in range(20))],
        *((f"j{number}", "continuous", "hub", f"spoke_{number}") for number in range(20)),
    )
    root = ET.fromstring(RobotTree(robot).to_svg())
    width, height = float(root.attrib["width"]), float(root.attrib["height"])
    assert width < 700 < height
    for box in root.iter(f"{SVG}rect"):
        assert float(box.attrib.get("x", 0)) + float(box.attrib["width"]) <= width
        assert float(box.attrib.get("y", 0)) + float(box.attrib["height"]) <= height


def test_a_link_alone(texts):
    shown = texts(RobotTree(robot_of("a")).to_svg())
    assert shown == ["r", "1 link, 0 joints (none moves)", "a"]


def test_hostile_names_are_only_names(texts):
    name = "&lt;script&gt;alert(1)&lt;/script&gt;" + "x" * 500
    robot = load_robot(f'<robot name="{name}"><link name="{name}"/></robot>', file="r.urdf")
    picture = RobotTree(robot)
    assert "<script" not in picture.to_svg()
    assert max(map(len, texts(picture.to_svg()))) < 100
    assert picture.to_png().startswith(b"\x89PNG")


def test_dot_is_that_of_urdf_to_graphviz(gripper):
    lines = RobotTree(gripper).to_dot().splitlines()
    assert lines[:3] == ["digraph G {", "node [shape=box];", '"arm" [label="arm"];']
    assert '"arm" -> "curl" [label="xyz: 1 0 0 \\nrpy: 0 0 0.3"]' in lines
    assert lines[-2:] == ['"nip" -> "thumb"', "}"]


def test_save_writes_by_suffix(gripper, tmp_path):
    picture = RobotTree(gripper)
    for suffix in (".svg", ".gv", ".png", ".PDF"):
        picture.save(tmp_path / f"robot{suffix}")
    assert (tmp_path / "robot.svg").read_text(encoding="utf-8") == picture.to_svg()
    assert (tmp_path / "robot.gv").read_text(encoding="utf-8") == picture.to_dot()
    assert (tmp_path / "robot.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "robot.PDF").read_bytes() == picture.to_pdf()
    with pytest.raises(UnknownNameError, match=r"no picture format '\.jpg'"):
        picture.save(str(tmp_path / "robot.jpg"))


def test_equal_robots_give_equal_bytes():
    one, two = (RobotTree(robot_of("ab", ("j", "fixed", "a", "b"))) for _ in range(2))
    assert one.to_svg() == two.to_svg()
    assert one.to_png(scale=1) == two.to_png(scale=1)


def test_notebooks_show_it(gripper):
    picture = RobotTree(gripper)
    assert picture._repr_svg_() == picture.to_svg()
    assert repr(picture) == "RobotTree(r: 4 links, 3 joints)"
