"""Links without mass: what is told, and what is fine."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from simkit.diagnostics import Severity
from simkit.urdf import Cylinder, load_robot
from simkit.urdf.inertia import shape_tensor

BODY = (
    '<inertial><mass value="2"/>'
    '<inertia ixx="0.0133" ixy="0" ixz="0" iyy="0.0133" iyz="0" izz="0.0133"/></inertial>'
)
BOX = '<collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>'
POLE = (
    '<collision><origin xyz="0 0 0.2"/>'
    '<geometry><cylinder radius="0.05" length="0.4"/></geometry></collision>'
)


def joint(parent, child, kind="continuous"):
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{child}_joint" type="{kind}">{ends}<axis xyz="0 0 1"/></joint>'


def link(name, inside=""):
    return f'<link name="{name}">{inside}</link>'


def test_a_robot_without_any_mass_is_to_look_at(told):
    shown = '<visual><geometry><sphere radius="1"/></geometry></visual>'
    (one,) = told(link("world") + link("base", shown) + joint("world", "base", "fixed"), "URDF-W10")
    assert one.severity is Severity.NOTE
    assert (one.span.line, one.what) == (
        1,
        "no link has a mass or a collision shape: a robot to look at, not to simulate",
    )
    assert told(link("world"), "URDF-W10") == []


def test_a_moving_link_without_mass_is_lost_with_all_below(told):
    links = (
        link("base", BODY + BOX)
        + "\n"
        + link("arm", POLE)
        + link("hand", BODY)
        + link("finger", BODY)
    )
    text = links + joint("base", "arm") + joint("arm", "hand") + joint("hand", "finger")
    (one,) = told(text, "URDF-W10")
    assert one.severity is Severity.WARNING
    assert (one.span.line, one.path) == (3, "robot/link[arm]")
    assert "and what hangs on it ('hand', 'finger')" in one.gazebo
    assert "1 kg" in one.here


def test_the_remedy_mends_it_and_is_the_formula_of_the_shape(told):
    text = link("base", BODY + BOX) + link("arm", POLE) + joint("base", "arm")
    (one,) = told(text, "URDF-W10")
    element = one.remedy[one.remedy.index("<inertial>") : one.remedy.index("</inertial>") + 11]
    mended = text.replace(POLE, POLE + element)
    assert {found.rule for found in told(mended)} == {"URDF-I45", "GZ-W06"}
    inertial = load_robot(f'<robot name="r">{mended}</robot>', file="r").links["arm"].inertial
    assert inertial is not None
    tensor = shape_tensor(Cylinder(0.05, 0.4), inertial.mass)
    assert inertial.ixx == pytest.approx(tensor[0][0], rel=1e-3)
    assert inertial.izz == pytest.approx(tensor[2][2], rel=1e-3)
    assert inertial.origin.xyz == (0.0, 0.0, 0.2)
    # as dense as the box: 2 kg in 0.008 m³
    assert inertial.mass == pytest.approx(2 / 0.008 * 3.14159 * 0.05**2 * 0.4, rel=0.02)


def test_a_tensor_in_a_remedy_stands_in_the_axes_of_the_shape(told):
    turned = POLE.replace('xyz="0 0 0.2"', 'xyz="0 0.2 0" rpy="1.570796 0 0"')
    (one,) = told(link("base", BODY) + link("arm", turned) + joint("base", "arm"), "URDF-W10")
    element = ET.fromstring(
        one.remedy[one.remedy.index("<inertial>") : one.remedy.index("</inertial>") + 11]
    )
    assert element.find("origin").attrib == {"xyz": "0 0.2 0", "rpy": "1.570796 0 0"}
    assert float(element.find("inertia").get("izz")) < float(element.find("inertia").get("ixx"))


def test_a_misspelt_link_at_a_joint_is_not_told_as_a_missing_mass_too(told):
    def rules(text):
        return [one.rule for one in told(text)]

    arm = link("arm", BODY + BOX) + joint("trunk", "arm")
    root = link("base_link") + link("trunk", BODY + BOX) + joint("base_link", "trunk", "fixed")
    tool = link("tool", "") + joint("arm", "tool", "fixed")
    whole = root + arm + tool
    assert "URDF-W10" not in rules(whole)
    for wrong in ('<link name="base_lnk"', '<link name="tol"', '<link name="trnk"'):
        right = wrong.replace("lnk", "link").replace("tol", "tool").replace("trnk", "trunk")
        slipped = rules(whole.replace(right, wrong))
        assert ("URDF-E02" in slipped, "URDF-W10" in slipped) == (True, False)
    for end in ('parent link="base_link"', 'child link="tool"', 'parent link="arm"'):
        slipped = rules(whole.replace(end, end[:-1] + 'x"'))
        assert ("URDF-E02" in slipped, "URDF-W10" in slipped) == (True, False)


def test_a_robot_to_look_at_is_told_so_once_its_tree_is_whole(told):
    shown = '<visual><geometry><sphere radius="1"/></geometry></visual>'
    text = link("base", shown) + link("arm", shown) + joint("base", "arm")
    assert [one.rule for one in told(text, "URDF-W10")] == ["URDF-W10"]
    assert told(text.replace('<link name="base"', '<link name="bse"'), "URDF-W10") == []


def test_a_missing_mass_is_told_beside_a_misspelt_link_elsewhere(told):
    links = link("base", BODY + BOX) + link("arm", POLE) + link("hand", BODY)
    text = links + joint("base", "arm") + joint("amr", "hand")
    assert {"URDF-E02", "URDF-W10"} <= {one.rule for one in told(text)}


def test_a_root_without_mass_loses_the_whole_robot(told):
    (one,) = told(link("base") + link("arm", BODY) + joint("base", "arm"), "URDF-W10")
    assert "the whole robot is missing" in one.gazebo


@pytest.mark.parametrize(
    "text",
    [
        link("world") + link("base", BODY) + joint("world", "base", "fixed"),
        link("base") + link("body", BODY) + joint("base", "body", "fixed"),
        link("body", BODY) + link("camera") + joint("body", "camera", "fixed"),
    ],
    ids=["the world", "a massless root on a fixed joint", "a frame on a fixed joint"],
)
def test_links_that_need_no_mass(told, text):
    assert told(text, "URDF-W10") == []


def test_a_shape_on_a_fixed_joint_is_only_worth_a_note(told):
    text = link("body", BODY) + link("bumper", BOX) + joint("body", "bumper", "fixed")
    (one,) = told(text, "URDF-W10")
    assert one.severity is Severity.NOTE
    assert "one body with 'body'" in one.gazebo


def test_a_fixed_joint_that_is_preserved_carries_nothing(told):
    text = link("body", BODY) + link("bumper", BOX) + joint("body", "bumper", "fixed")
    kept = '<gazebo reference="bumper_joint"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    (one,) = told(text + kept, "URDF-W10")
    assert one.severity is Severity.WARNING


@pytest.mark.parametrize(
    ("mass", "severity", "words"),
    [
        ("-1", Severity.ERROR, "Write 1 if only the sign"),
        ("0", Severity.WARNING, "Write its mass in kilograms"),
        ("1e-6", Severity.WARNING, "Write its mass in kilograms"),
    ],
)
def test_a_mass_that_is_none(told, mass, severity, words):
    wrong = BODY.replace('"2"', f'"{mass}"')
    text = link("base", BODY + BOX) + "\n" + link("arm", wrong + BOX) + joint("base", "arm")
    (one,) = told(text, "URDF-W40")
    assert (one.severity, one.span.line) == (severity, 3)
    assert one.source[one.span.column - 1 :].startswith(mass)
    assert words in one.remedy
    assert told(text.replace(wrong, BODY), "URDF-W40") == []


def test_a_mass_of_zero_on_a_fixed_joint_is_only_worth_a_note(told):
    zero = BODY.replace('"2"', '"0"')
    (one,) = told(
        link("base", BODY) + link("tip", zero) + joint("base", "tip", "fixed"), "URDF-W40"
    )
    assert one.severity is Severity.NOTE
    assert (
        told(link("world", zero) + link("base", BODY) + joint("world", "base", "fixed"), "URDF-W40")
        == []
    )


def test_a_root_with_a_mass_makes_kdl_complain(told):
    (one,) = told(
        link("base_link", BODY) + link("arm", BODY) + joint("base_link", "arm"), "URDF-I45"
    )
    assert one.severity is Severity.NOTE
    assert '<link name="base_footprint"/>' in one.remedy
    above = link("base_footprint") + joint("base_footprint", "base_link", "fixed")
    assert told(above + link("base_link", BODY), "URDF-I45") == []
