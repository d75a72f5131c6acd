"""`<gazebo>` blocks: what they belong to, the tags in them, colours."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

MASS = '<inertial><mass value="1"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>'
ROBOT = f"""<link name="chassis">{MASS}</link><link name="laser_link"/>
<joint name="laser_joint" type="fixed"><parent link="chassis"/><child link="laser_link"/></joint>
"""
SENSOR = '<sensor type="ray" name="eye"/>'


def block(inside, reference="chassis"):
    return ROBOT + f'<gazebo reference="{reference}">\n{inside}\n</gazebo>'


def test_a_sensor_of_a_link_that_is_not_there_is_lost(told):
    (one,) = told(block(SENSOR, "lidar"), "GZ-E01")
    assert (one.severity, one.span.line) == (Severity.ERROR, 4)
    assert "'lidar'; lost with it: the sensor 'eye'" in one.what
    added = one.remedy[4 : one.remedy.index(", with")].replace(" and <joint", "<joint")
    assert told(block(SENSOR, "lidar") + added, "GZ-E01") == []
    assert '<parent link="chassis"/>' in one.remedy


def test_a_misspelt_reference_gets_the_nearest_name(told):
    (one,) = told(block(SENSOR, "laser_lnk"), "GZ-E01")
    assert "'laser_link'" in one.remedy
    (one,) = told(block("<mu1>1</mu1>", "chasis"), "GZ-E01")
    assert one.severity is Severity.WARNING
    assert one.source[one.span.column - 1 :].startswith("chasis")


@pytest.mark.parametrize("reference", ["chassis", "laser_link", "laser_joint", ""])
def test_references_that_are_there(told, reference):
    assert told(block("<plugin name='p' filename='libx.so'/>", reference), "GZ-E01") == []


@pytest.mark.parametrize(
    ("inside", "reference", "severity", "what", "remedy"),
    [
        ("<mu>1</mu>", "chassis", Severity.WARNING, "<mu> is no tag", "<mu1>"),
        (
            "<selfColide>true</selfColide>",
            "chassis",
            Severity.WARNING,
            "<selfColide>",
            "<selfCollide>",
        ),
        (
            "<mu1>slippery</mu1>",
            "chassis",
            Severity.WARNING,
            "holds no number: 'slippery'",
            "<mu1>1.0</mu1>",
        ),
        (
            "<turnGravityOff>on</turnGravityOff>",
            "chassis",
            Severity.WARNING,
            "neither true nor false: 'on'",
            "true",
        ),
        (
            "<mu1>1</mu1>",
            "laser_joint",
            Severity.NOTE,
            "<mu1> is for links, and 'laser_joint' is a joint",
            "names a link",
        ),
        (
            "<provideFeedback>true</provideFeedback>",
            "chassis",
            Severity.NOTE,
            "is for joints",
            "names a joint",
        ),
        (
            "<mu1>1</mu1>",
            "",
            Severity.WARNING,
            "<mu1> needs a link that it belongs to",
            "names a link",
        ),
    ],
)
def test_tags_without_effect(told, inside, reference, severity, what, remedy):
    (one,) = told(block(inside, reference), "GZ-W12")
    assert (one.severity, one.span.line, one.span.column) == (severity, 5, 2)
    assert what in one.what
    assert remedy in one.remedy


@pytest.mark.parametrize(
    ("inside", "reference"),
    [
        ('<mu1>0.2</mu1><mu2 value="0.3"/><kp>1e6</kp><material>Gazebo/Red</material>', "chassis"),
        (
            "<preserveFixedJoint>true</preserveFixedJoint><implicitSpringDamper>1</implicitSpringDamper>",
            "laser_joint",
        ),
        ("<static>true</static><custom_tag/>", ""),
        ("<visual><material/></visual><gravity>true</gravity>", "chassis"),
    ],
)
def test_tags_that_may_stand_there(told, inside, reference):
    assert told(block(inside, reference), "GZ-W12") == []


def test_fixed_joints_are_melted_which_is_worth_one_note(told):
    (one,) = told(ROBOT, "GZ-W07")
    assert (one.severity, one.span.line) == (Severity.NOTE, 3)
    assert "'laser_link'" in one.what
    kept = one.remedy[one.remedy.index("<gazebo") : one.remedy.index("</gazebo>") + 9]
    assert told(ROBOT + kept, "GZ-W07") == []
    assert told(ROBOT.replace('"chassis"', '"world"'), "GZ-W07") == []


def coloured(material, gazebo):
    visual = '<visual><geometry><sphere radius="1"/></geometry><material name="m"><color rgba="{} 1"/></material></visual>'
    inside = (
        "" if gazebo is None else f'\n<gazebo reference="a"><material>{gazebo}</material></gazebo>'
    )
    return f'<link name="a">{MASS}{visual.format(material)}</link>{inside}'


def test_colours_that_gazebo_will_not_show_are_told_once(told):
    (one,) = told(coloured("1 0 0", None) + coloured("0 1 0", None).replace('"a"', '"b"'), "GZ-W13")
    assert one.severity is Severity.NOTE
    assert "'a', 'b'" in one.what
    assert '<gazebo reference="a"><material>Gazebo/Red</material></gazebo>' in one.remedy
    assert told(coloured("1 0 0", None).replace(MASS, ""), "GZ-W13") == []


def test_two_colours_of_one_link(told):
    (one,) = told(coloured("0 0 1", "Gazebo/Orange"), "GZ-W13")
    assert one.severity is Severity.NOTE
    assert one.source[one.span.column - 1 :].startswith("Gazebo/Orange")
    assert "Gazebo/Blue is nearest" in one.remedy
    assert told(coloured("0 0 0.9", "Gazebo/Blue"), "GZ-W13") == []


def test_a_misspelt_material(told):
    (one,) = told(coloured("1 0.5 0", "Gazebo/Oragne"), "GZ-W13")
    assert one.severity is Severity.WARNING
    assert "'Gazebo/Orange'" in one.remedy
    assert told(coloured("1 0.5 0", "Gazebo/WoodFloor"), "GZ-W13") == []
    assert told(coloured("1 0.5 0", "MyMaterial"), "GZ-W13") == []
