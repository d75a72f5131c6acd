"""A file as the rules see it, however faulty."""

from __future__ import annotations

import pytest

from simkit.urdf.model import Box, Cylinder, Mesh, Sphere
from simkit.urdf.rules.sheet import Sheet, read_sheet
from simkit.xml import parse_xml


def sheet(*parts: str) -> Sheet:
    return read_sheet(
        parse_xml('<robot name="r">\n' + "\n".join(parts) + "\n</robot>\n", file="urdf/r.urdf")
    )


def shape(text: str):
    (link,) = sheet(f'<link name="a"><visual><geometry>{text}</geometry></visual></link>').links
    return link.visuals[0].shape


def test_links_and_joints_are_listed_by_name_and_by_ends():
    found = sheet(
        '<link name="a"/><link name="b"/><link name="b"/><link/>',
        '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>',
        '<joint name="k" type="fixed"><parent link="a"/><child link="nowhere"/></joint>',
        '<joint name="k"><parent link="b"/></joint>',
    )
    assert [link.name for link in found.links] == ["a", "b", "b", None]
    assert found.link_by_name["b"] is found.links[1]
    assert found.joint_by_name["k"] is found.joints[1]
    assert [joint.name for joint in found.joints_below["a"]] == ["j", "k"]
    assert [joint.name for joint in found.joints_above["nowhere"]] == ["k"]
    assert [link.name for link in found.links if found.is_root(link)] == ["a"]
    assert found.joints[2].child is None


def test_values_are_read_or_none():
    found = sheet(
        '<joint name="j" type="revolute"><origin xyz="1 2 3" rpy="x"/><axis xyz="0 0 2"/>'
        '<limit lower="-1" effort="high"/></joint>',
        '<joint name="k"/>',
    )
    one, other = found.joints
    assert (one.origin.xyz, one.origin.rpy, one.axis) == ((1, 2, 3), None, (0, 0, 2))
    assert one.limit is not None
    assert (one.limit.lower, one.limit.upper, one.limit.effort) == (-1, 0, None)
    assert one.moves
    assert (other.type, other.axis, other.origin.xyz, other.limit) == (
        None,
        (1, 0, 0),
        (0, 0, 0),
        None,
    )


def test_shapes():
    assert shape('<box size="1 2 3"/>') == Box((1, 2, 3))
    assert shape('<cylinder radius="1" length="-2"/>') == Cylinder(1, -2)
    assert shape('<sphere radius="0"/>') == Sphere(0)
    assert shape('<mesh filename="a.stl" scale="2 2 2"/>') == Mesh("a.stl", (2, 2, 2))
    assert [shape(text) for text in ("", "<cone/>", '<box size="1 2"/>', '<sphere r=""/>')] == [
        None
    ] * 4


def test_inertials_and_materials():
    found = sheet(
        '<material name="red"><color rgba="1 0 0 1"/></material>',
        '<link name="a"><visual><material name="red"/></visual><inertial><mass value="2"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>',
        '<link name="b"><inertial><mass value="x"/><inertia ixx="1"/></inertial></link>',
    )
    one, other = (link.inertial for link in found.links)
    assert one is not None
    assert other is not None
    assert (one.mass, one.tensor) == (2, (1, 0, 0, 1, 0, 1))
    assert (other.mass, other.tensor) == (None, None)
    assert [(m.name, m.is_global, m.rgba) for m in found.materials] == [
        ("red", True, (1, 0, 0, 1)),
        ("red", False, None),
    ]


@pytest.mark.parametrize(
    "part",
    [
        '<lnik name="a"/>',
        '<Link name="a"/>',
        '<link nmae="a"/>',
        '<wrapper><link name="a"/></wrapper>',
    ],
)
def test_a_misspelt_or_misplaced_link_counts(part):
    assert "a" in sheet(part).link_by_name


def test_misspelt_parts_count():
    found = sheet(
        '<link name="a"><inertail><mass vlaue="2"/></inertail><visaul/></link>',
        '<joint name="j" type="revolute"><parent name="a"/><child>b</child>'
        '<limits min="-1"/></joint>',
    )
    (link,), (joint,) = found.links, found.joints
    assert link.inertial is not None
    assert link.inertial.mass == 2
    assert len(link.visuals) == 1
    assert (joint.parent, joint.child) == ("a", "b")
    assert joint.limit is not None
    assert joint.limit.lower == -1


def test_what_is_in_gazebo_and_its_kin_is_no_part_of_the_robot():
    found = sheet(
        '<gazebo><joint name="x"/><plugin name="p" filename="lib.so"><link name="l"/></plugin></gazebo>',
        '<transmission name="t"><type>a/B</type><joint name="hip"/><actuator name="m"/></transmission>',
        '<ros2_control><joint name="y"/></ros2_control>',
        '<gazebo reference="a"><sensor><plugin filename="s.so"/></sensor></gazebo>',
    )
    assert (found.links, found.joints) == ((), ())
    assert [(one.filename, one.gazebo.reference) for one in found.plugins] == [
        ("lib.so", None),
        ("s.so", "a"),
    ]
    (transmission,) = found.transmissions
    assert transmission.type == "a/B"
    assert [joint.get("name") for joint in transmission.joints] == ["hip"]


@pytest.mark.parametrize(
    "text", ["", "<sdf/>", '<robot><xacro:if value="1"/><link name="a"/></robot>']
)
def test_without_a_robot_all_lists_are_empty(text):
    found = read_sheet(parse_xml(text, file="x"))
    assert found.robot is None
    assert (found.links, found.joints, found.materials, found.gazebo) == ((), (), (), ())
