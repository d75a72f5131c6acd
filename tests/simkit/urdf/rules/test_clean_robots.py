"""No false alarm: the robots of the course, and those of the book without their misprints, get nothing worse than a note."""

from __future__ import annotations

from pathlib import Path

import pytest

from simkit.diagnostics import Severity
from simkit.packages import PackagePath
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

ROOT = Path(__file__).resolve().parents[4]
ROBOTS = sorted([*ROOT.glob("robots/*/urdf/*.urdf"), *ROOT.glob("tests/simkit/urdf/robots/*.urdf")])


def test_there_are_robots():
    names = {path.stem for path in ROBOTS}
    assert {"hello_ros_robot_1", "hello_gazebo_robot_2", "m2wr", "practice_car"} <= names


@pytest.mark.parametrize("path", ROBOTS, ids=lambda path: f"{path.parts[-3]}-{path.stem}")
def test_a_robot_gets_nothing_worse_than_notes(path):
    document = parse_xml(path.read_bytes(), file=str(path))
    found = check_robot(document, packages=PackagePath([ROOT / "robots"]))
    assert [one for one in found if one.severity is not Severity.NOTE] == []
