"""What urdfdom takes from a file, and what it loses."""

from __future__ import annotations

import pytest

from simkit.urdf import (
    Box,
    Cylinder,
    Inertial,
    JointType,
    Limit,
    Mesh,
    Mimic,
    Pose,
    Safety,
    Sphere,
    read_robot,
)
from simkit.xml import Span

BALL = '<geometry><sphere radius="1"/></geometry>'
SILVER = (0.75, 0.75, 0.75, 1.0)


def link_of(read, inner):
    reading = read(f'<link name="a">{inner}</link>')
    assert reading.robot is not None
    return reading.robot.links["a"]


def test_the_arm_of_the_book(robots):
    path = robots / "hello_gazebo_robot_1.urdf"
    robot = read_robot(path.read_bytes(), file="hello_gazebo_robot_1.urdf").robot
    assert robot is not None
    assert (robot.name, robot.root) == ("hello_ros_robot", "world")
    assert list(robot.links) == ["world", "base_link", "torso", "upper_arm"]
    assert list(robot.joints) == ["fixed", "hip", "shoulder"]
    arm, shoulder = robot.links["upper_arm"], robot.joints["shoulder"]
    assert arm.inertial == Inertial(
        mass=1.0, origin=Pose((0.0, 0.0, 0.2)), ixx=0.01396, iyy=0.01396, izz=0.00125
    )
    (visual,), (collision,) = arm.visuals, arm.collisions
    assert visual.geometry == collision.geometry == Cylinder(radius=0.05, length=0.4)
    assert visual.origin == collision.origin == Pose((0.0, 0.0, 0.2))
    assert visual.material is not None
    assert (visual.material.name, visual.material.rgba) == ("silver", SILVER)
    assert (shoulder.type, shoulder.axis) == (JointType.CONTINUOUS, (0.0, 1.0, 0.0))
    assert shoulder.origin == Pose((0.0, -0.1, 0.45), (0.0, 1.5708, 0.0))
    assert (shoulder.parent, shoulder.child, shoulder.limit) == ("torso", "upper_arm", None)
    assert [joint.name for joint in robot.joints_below("torso")] == ["shoulder"]


def test_links_and_joints_know_where_they_are_written(robots):
    path = robots / "hello_ros_robot_3.urdf"
    reading = read_robot(path.read_bytes(), file="hello_ros_robot_3.urdf")
    assert reading.robot is not None
    lines = path.read_text(encoding="utf-8").splitlines()
    for things in (reading.robot.links, reading.robot.joints):
        for name, thing in things.items():
            line = lines[thing.element.span.line - 1]
            assert f'name="{name}"' in line
            assert line[thing.element.span.column - 1 :].startswith(thing.element.name)
    root = reading.document.root
    assert root is not None
    assert root.child("joint") is reading.robot.joints["fixed"].element
    assert reading.robot.document is reading.document


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_places_hold_with_any_newlines_and_letters(newline, mark):
    lines = ["<robot name='r'>", " <!-- žluťoučký 车 --><link name='ä'/>", "</robot>"]
    reading = read_robot((mark + newline.join(lines)).encode(), file="r.urdf")
    assert reading.robot is not None
    element = reading.robot.links["ä"].element
    assert element.span == Span(2, 23, 4)
    assert reading.document.root is not None
    assert element is reading.document.root.child("link")


def test_what_is_no_xml_but_is_read_on_has_a_place_too():
    reading = read_robot("<robot name=r><link name=a/ ></robot>", file="r.urdf")
    assert reading.robot is None
    reading = read_robot("<sdf/>\n<robot name=r><link name=a /></robot>", file="r.urdf")
    assert reading.robot is not None
    assert reading.robot.links["a"].element.span == Span(2, 16, 4)


def test_the_first_definition_of_a_material_counts_for_all_links(read):
    def visual(rgba):
        return f'<visual>{BALL}<material name="m"><color rgba="{rgba}"/></material></visual>'

    reading = read(
        f'<link name="a">{visual("1 0 0 1")}</link>'
        f'<link name="b">{visual("0 1 0 1")}{visual("0 0 1 1")}</link>'
        '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
    )
    assert reading.robot is not None
    colours = [v.material.rgba for x in reading.robot.links.values() for v in x.visuals]
    assert colours == [(1.0, 0.0, 0.0, 1.0)] * 3
    assert list(reading.robot.materials) == ["m"]


def test_a_material_of_the_robot_counts_before_all(read):
    reading = read(
        f'<link name="a"><visual>{BALL}<material name="m"><color rgba="0 1 0 1"/></material>'
        '</visual></link><material name="m"><color rgba="1 0 0 1"/>'
        '<texture filename="wood.png"/></material>'
    )
    assert reading.robot is not None
    (visual,) = reading.robot.links["a"].visuals
    assert visual.material == reading.robot.materials["m"]
    assert visual.material.rgba == (1.0, 0.0, 0.0, 1.0)
    assert visual.material.texture == "wood.png"


def test_materials_without_a_colour(read):
    reading = read(
        f'<material name="m"/><link name="a"><visual>{BALL}<material name="n"/></visual>'
        f'<visual>{BALL}<material name="m"/></visual>'
        f'<visual>{BALL}<material name=""><color rgba="1 1 1 1"/></material></visual>'
        f"<visual>{BALL}</visual></link>"
    )
    assert reading.robot is not None
    undefined, black, nameless, none = (v.material for v in reading.robot.links["a"].visuals)
    assert (undefined.name, undefined.rgba) == ("n", None)
    assert (black.name, black.rgba) == ("m", (0.0, 0.0, 0.0, 1.0))
    assert (nameless.name, nameless.rgba) == ("", (1.0, 1.0, 1.0, 1.0))
    assert none is None


def test_a_bad_inertial_loses_what_follows_but_not_the_mass(read):
    link = link_of(
        read,
        f'<visual>{BALL}</visual><inertial><origin xyz="0 0 1"/><mass value="2"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" izz="1"/></inertial>'
        f"<collision>{BALL}</collision>",
    )
    assert link.inertial == Inertial(mass=2.0, origin=Pose((0.0, 0.0, 1.0)))
    assert link.visuals == link.collisions == ()


def test_a_bad_visual_loses_later_visuals_and_all_collisions(read):
    link = link_of(
        read,
        f'<visual name="one">{BALL}</visual><visual/><visual>{BALL}</visual>'
        f'<collision>{BALL}</collision><inertial><mass value="1"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>',
    )
    assert [visual.name for visual in link.visuals] == ["one"]
    assert link.collisions == ()
    assert link.inertial is not None
    assert link.inertial.izz == 1.0


def test_the_first_of_several_inertials_origins_and_shapes(read):
    tensor = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    link = link_of(
        read,
        f'<inertial><mass value="1"/><mass value="2"/>{tensor}</inertial><inertial/>'
        '<visual><origin xyz="1 0 0"/><origin xyz="2 0 0"/><geometry><box size="1 2 3"/>'
        '<sphere radius="1"/></geometry><geometry/></visual>',
    )
    assert link.inertial is not None
    assert link.inertial.mass == 1.0
    (visual,) = link.visuals
    assert (visual.geometry, visual.origin.xyz) == (Box((1.0, 2.0, 3.0)), (1.0, 0.0, 0.0))


def test_shapes(read):
    shapes = '<sphere radius="0.1"/>', '<mesh filename="a.stl" scale="1 2 3"/>'
    inner = "".join(f"<collision><geometry>{shape}</geometry></collision>" for shape in shapes)
    ball, mesh = (one.geometry for one in link_of(read, inner).collisions)
    assert ball == Sphere(0.1)
    assert isinstance(mesh, Mesh)
    assert (mesh.filename, mesh.scale, mesh.path) == ("a.stl", (1.0, 2.0, 3.0), None)


def test_all_of_a_joint(robot):
    joint = robot(
        '<link name="a"/><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
        '<child link="b"/><axis xyz="0 0 2"/><limit lower="-1" upper="2" effort="3" velocity="4"/>'
        '<dynamics friction="0.5"/><mimic joint="j" multiplier="-1"/><calibration rising="1"/>'
        '<safety_controller k_velocity="5" soft_upper_limit="1.5"/></joint>'
    ).joints["j"]
    assert joint.axis == (0.0, 0.0, 2.0)
    assert joint.limit == Limit(lower=-1.0, upper=2.0, effort=3.0, velocity=4.0)
    assert (joint.damping, joint.friction) == (0.0, 0.5)
    assert joint.mimic == Mimic(joint="j", multiplier=-1.0, offset=0.0)
    assert joint.safety == Safety(soft_lower=0.0, soft_upper=1.5, k_position=0.0, k_velocity=5.0)
    assert joint.moves


def test_a_refusal_in_one_sentence(read):
    assert read('<link name="a"/>').refusal == ""
    assert read("").refusal == "No link elements found in urdf file"
    two_faults = read(
        '<link name="a"><visual/></link><link name="b"/><joint name="j" type="ball"/>'
    )
    assert two_faults.refusal == "Joint [j] has no known type [ball]"
    assert len(two_faults.messages) == 3


def test_names_in_other_encodings_can_be_printed():
    reading = read_robot(b"<robot name='gr\xfcn'><link name='\xe4'/></robot>", file="r.urdf")
    assert reading.robot is not None
    assert (reading.robot.name, reading.robot.root) == ("gr\ufffdn", "\ufffd")


def test_any_text_and_any_bytes_give_a_reading():
    for text in ("", "\x00", "\ud800", "<robot name='\ud800'><link name='a'/></robot>", "<" * 999):
        assert read_robot(text, file="r.urdf").document.file == "r.urdf"
    for data in (b"\xff\xfe<\x00", bytes(range(256)), "<robot/>".encode("utf-16")):
        assert read_robot(data, file="r.urdf").robot is None


def test_deep_nesting_does_no_harm():
    depth = 20_000
    text = "<robot name='r'><link name='a'>" + "<x>" * depth + "</x>" * depth + "</link></robot>"
    reading = read_robot(text, file="r.urdf")
    assert reading.robot is not None
    assert list(reading.robot.links) == ["a"]
