from __future__ import annotations

import pytest

from simkit.diagnostics import Diagnostic, Severity
from simkit.errors import SimkitError
from simkit.urdf import UrdfError, load_robot, read_robot, read_robot_file
from simkit.urdf import rules as urdf_rules
from simkit.urdf.loader import robot_of
from simkit.xml import Span

NO_LINK = '<robot name="r"/>'


def test_a_robot_of_the_book(printed_robots):
    text = (printed_robots / "practice_car.urdf").read_text(encoding="utf-8")
    assert load_robot(text, file="practice_car.urdf").root == "base_link"


def test_the_first_error_stands_in_one_line(printed_robots):
    text = (printed_robots / "faulty" / "doubled_end_tag.urdf").read_text(encoding="utf-8")
    with pytest.raises(UrdfError) as caught:
        load_robot(text, file="arm.urdf")
    assert isinstance(caught.value, SimkitError)
    before = text[: text.index("</collision>\n    </collision>")]
    assert str(caught.value).startswith(f"arm.urdf:{before.count(chr(10)) + 2}:")
    assert "\n" not in str(caught.value)
    assert any(one.severity is Severity.ERROR for one in caught.value.diagnostics)


def test_place_fault_and_remedy_are_those_of_the_first_error(monkeypatch):
    def find(severity, what):
        return Diagnostic(
            rule="URDF-X00",
            severity=severity,
            file="arm.urdf",
            span=Span(3, 7),
            source="",
            what=what,
            remedy="Add one.",
        )

    found = (find(Severity.NOTE, "odd"), find(Severity.ERROR, "no link"))
    monkeypatch.setattr(urdf_rules, "check_robot", lambda document, **_: found)
    with pytest.raises(UrdfError, match=r"^arm\.urdf:3:7: no link; Add one\.$") as caught:
        load_robot(NO_LINK, file="arm.urdf")
    assert caught.value.diagnostics == found


def test_urdfdom_has_the_word_where_no_rule_has_one(monkeypatch):
    monkeypatch.setattr(urdf_rules, "check_robot", lambda document, **_: ())
    with pytest.raises(UrdfError, match=r"^arm\.urdf: No link elements found in urdf file$"):
        robot_of(read_robot(NO_LINK, file="arm.urdf"))


def test_a_file(robots, tmp_path):
    robot = read_robot_file(robots / "hello_ros_robot_1.urdf").robot
    assert robot is not None
    assert robot.root == "world"
    with pytest.raises(UrdfError, match="there is no such file"):
        read_robot_file(tmp_path / "arm.urdf")
    with pytest.raises(UrdfError, match=r"(irectory|ermission)"):
        read_robot_file(tmp_path)
