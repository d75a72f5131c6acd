"""One robot with all the faults of the book's m2wr: each is named, with its place and its remedy."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import pytest

from simkit.diagnostics import Severity
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

FILE = Path(__file__).parents[1] / "faults" / "two_wheels_many_faults.urdf"


class Told(NamedTuple):
    """What must be told."""

    fault: str
    """Which fault of the book it is."""
    rule: str
    line: int
    column: int
    at: str
    """What stands there."""
    what: str
    """Words of what is wrong."""
    remedy: str
    """Words of what would be right."""


TOLD = [
    Told(
        "a sensor without its link",
        "GZ-E01",
        26,
        22,
        "sensor_laser",
        "'sensor_laser'; lost with it: the sensor 'laser'",
        '<link name="sensor_laser"/>',
    ),
    Told("b pose of SDF", "URDF-W17", 51, 6, "pose", "<pose>", "spawn_model says: -z 0.1"),
    Told("b spawned in the floor", "GZ-W06", 96, 6, "collision", "0.1 m below", "-z 0.1 "),
    Told(
        "c sides swapped",
        "GZ-W02",
        16,
        18,
        "joint_left_wheel",
        "the robot turns right",
        "<leftJoint>joint_right_wheel</leftJoint>",
    ),
    Told(
        "d wheelSeparation",
        "GZ-W03",
        18,
        24,
        "0.4",
        "0.4 m, but the wheels are 0.3 m apart",
        "<wheelSeparation>0.3</wheelSeparation>",
    ),
    Told("e ball seen elsewhere", "URDF-I16", 69, 8, "origin", "0.15 m off", 'xyz="0.2 0 -0.05"'),
    Told("f surface of SDF", "URDF-W17", 73, 8, "surface", "<surface>", "<mu1>0</mu1>"),
    Told("f ball drags", "GZ-W05", 68, 6, "collision", "friction of 1", "<mu1>0.0</mu1>"),
    Told(
        "g joint_properties",
        "URDF-W17",
        115,
        6,
        "joint_properties",
        "<joint_properties>",
        '<dynamics damping="1.0" friction="1.0"/>',
    ),
    Told(
        "g joint_properties",
        "URDF-W17",
        143,
        6,
        "joint_properties",
        "<joint_properties>",
        '<dynamics damping="1.0" friction="1.0"/>',
    ),
    Told("h axis rpy", "URDF-W17", 113, 23, "rpy", "'rpy'", "An axis has only xyz"),
    Told("h axis rpy", "URDF-W17", 141, 23, "rpy", "'rpy'", "An axis has only xyz"),
    Told("i torque", "GZ-W10", 20, 8, "torque", "<torque>", "<wheelTorque>0.1</wheelTorque>"),
    Told(
        "i torque too small",
        "GZ-W04",
        20,
        8,
        "torque",
        "5.4 kg by 0.3704 m/s²",
        "<wheelTorque>0.27</wheelTorque>",
    ),
    Told(
        "j izz", "URDF-W47", 55, 79, "0.10620833", "izz: 0.1062 instead of 0.1417", 'izz="0.1417"'
    ),
    Told(
        "k mass above the body",
        "URDF-I14",
        54,
        8,
        "origin",
        "0.065 m above",
        '<origin xyz="0 0 0"/>',
    ),
    Told(
        "l wheels in the body",
        "URDF-I44",
        90,
        4,
        "link",
        "'link_chassis' and 'link_right_wheel'",
        "outward",
    ),
    Told("m 1.5707", "URDF-I46", 103, 32, "0 1.5707 1.5707", "and 11 more", "1.570796"),
    Told("n xmlns:xacro", "URDF-I48", 4, 26, "xmlns:xacro", "'xacro'", "Leave out xmlns:xacro"),
    Told("o two colours", "GZ-W13", 10, 15, "Gazebo/Orange", "(Orange)", "Gazebo/Grey"),
    Told(
        "root with a mass",
        "URDF-I45",
        52,
        6,
        "inertial",
        "'link_chassis'",
        '<link name="base_link"/>',
    ),
]


@pytest.fixture(scope="module")
def found():
    return check_robot(parse_xml(FILE.read_bytes(), file=FILE.name))


@pytest.mark.parametrize("told", TOLD, ids=lambda told: f"{told.fault}-{told.line}")
def test_each_fault_is_named_with_place_and_remedy(told, found):
    here = [one for one in found if (one.span.line, one.span.column) == told[2:4]]
    one = next(one for one in here if one.rule == told.rule)
    assert one.source[one.span.column - 1 :].startswith(told.at)
    assert told.what in one.what
    assert told.remedy in one.remedy


def test_nothing_else_is_told(found):
    places = {(told.rule, told.line, told.column) for told in TOLD}
    assert [one for one in found if (one.rule, one.span.line, one.span.column) not in places] == []


def test_only_what_is_lost_is_an_error(found):
    assert [one.rule for one in found if one.severity is Severity.ERROR] == ["GZ-E01"]


def test_the_mended_robot_has_nothing_worse_than_notes():
    text = FILE.read_text()
    for wrong, right in (
        ("    <pose>0 0 0.1 0 0 0</pose>\n", ""),
        ('<gazebo reference="sensor_laser">', '<gazebo reference="link_chassis">'),
        ("<frameName>sensor_laser<", "<frameName>link_chassis<"),
        ('xyz="-0.05 0.15 0"', 'xyz="-0.05 0.2 0"'),
        ('xyz="-0.05 -0.15 0"', 'xyz="-0.05 0.15 0"'),
        ('xyz="-0.05 0.2 0"', 'xyz="-0.05 -0.15 0"'),
        ("<wheelSeparation>0.4<", "<wheelSeparation>0.3<"),
        ("<torque>0.1</torque>", "<wheelTorque>5</wheelTorque>"),
        ('izz="0.10620833"', 'izz="0.14166667"'),
        ('<axis xyz="0 1 0" rpy="0 0 0"/>', '<axis xyz="0 1 0"/>'),
        ('<joint_properties damping="1.0" friction="1.0"/>', '<dynamics damping="0.1"/>'),
        ("<min>0.1<", "<min>0.5<"),
    ):
        assert wrong in text
        text = text.replace(wrong, right)
    start, end = text.index("      <surface>"), text.index("</surface>") + len("</surface>\n")
    text = text[:start] + text[end:]
    found = check_robot(parse_xml(text, file="mended.urdf"))
    assert [one for one in found if one.severity is not Severity.NOTE] == []
