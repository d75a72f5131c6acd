"""What a find says that ROS does with the file is what ROS does."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.diagnostics import Diagnostic, Severity
from simkit.urdf import read_robot
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

FAULTS = Path(__file__).parents[1] / "faults"
ARM = (FAULTS / "planted/00_clean.urdf").read_text("utf-8")
LOOPS = ("link_on_itself", "loop_below_the_root")
"""Accepted by ROS, which then prints without end; refused here."""
FILES = [path for path in sorted(FAULTS.rglob("*.urdf")) if path.stem not in LOOPS]


def finds(text: str | bytes) -> list[Diagnostic]:
    found = check_robot(parse_xml(text, file="arm.urdf"))
    return [one for one in found if one.severity is not Severity.NOTE]


def says_refused(text: str | bytes) -> bool:
    told = (one.gazebo for one in finds(text) if "accept" not in one.gazebo)
    return any(re.search(r"refuses the (whole )?file|document is empty", one) for one in told)


def is_refused(text: str | bytes) -> bool:
    return read_robot(text, file="arm.urdf").robot is None


def each_line_lost() -> list[str]:
    lines = ARM.split("\n")
    return ["\n".join(lines[:number] + lines[number + 1 :]) for number in range(len(lines))]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_file_is_said_to_be_refused_if_and_only_if_it_is(path):
    text = path.read_bytes()
    assert says_refused(text) == is_refused(text), [(one.what, one.gazebo) for one in finds(text)]


def test_so_it_is_with_each_line_of_a_robot_lost():
    for text in each_line_lost():
        assert says_refused(text) == is_refused(text), text


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("<link ", "<Link "),
        ("<joint ", "<jiont "),
        ("<limit ", "<limits "),
        ("<inertial>", "<inertail>"),
        ('<link name="torso"', "<link"),
        ('<link name="torso"', '<link name=""'),
        ('<parent link="base_link"/>', '<parent link=""/>'),
        ('<robot name="', '<robot version="1.00" name="'),
        ('<robot name="', '<robot version="2.0" name="'),
        ("<robot ", "<!DOCTYPE r [<!ENTITY e 'x'>]>\n<robot "),
        ("<origin ", "<orgin "),
        ("</robot>", "<link/></robot>"),
        ('<?xml version="1.0"?>', '<?xml version="1.0"'),
        ('<?xml version="1.0"?>', "<? version?>"),
    ],
)
def test_so_it_is_with_a_slip(before, after):
    assert before in ARM
    text = ARM.replace(before, after)
    tag, written = before.strip("< "), after.strip("< ")
    if before.startswith("<") and tag.isalpha() and written.isalpha():
        text = text.replace(f"</{tag}>", f"</{written}>")
    assert says_refused(text) == is_refused(text), [(one.what, one.gazebo) for one in finds(text)]


def test_a_file_in_utf_16_is_refused_and_said_to_be():
    for encoding in ("utf-16", "utf-16-le", "utf-16-be"):
        (one,) = finds(ARM.encode(encoding))
        assert (one.rule, one.span.line, one.span.column) == ("URDF-E01", 1, 1)
        assert "UTF-8" in one.remedy
        assert is_refused(ARM.encode(encoding))


@pytest.mark.parametrize(
    "text", ["", "\n \n", "404: Not Found", "joints:\n  - hip\n", "if a < b:\n    c = a & b\n"]
)
def test_a_file_without_an_element_is_one_find(text):
    (one,) = finds(text)
    assert one.rule == "URDF-E01"
    assert '<robot name="..."> with links and joints' in one.remedy


def test_a_web_page_is_one_find():
    page = "<html><head><meta charset=utf-8></head><body><p>Page &nbsp; not found<br></body></html>"
    (one,) = finds(page)
    assert one.rule == "URDF-E27"
    assert "web page" in one.remedy


def test_to_run_xacro_does_not_overwrite_the_file():
    text = '<robot name="r">\n<link name="$(arg side)_wheel"/>\n</robot>'
    for file, target in (
        ("a.urdf", "a_made.urdf"),
        ("a.urdf.xacro", "a.urdf"),
        ("a.xacro", "a.urdf"),
    ):
        (one,) = check_robot(parse_xml(text, file=file))
        assert one.rule == "URDF-E29"
        assert f"xacro {file} > {target};" in one.remedy


@pytest.mark.parametrize(
    ("rgba", "right", "follows"),
    [
        ("255 128 0 255", "1 0.502 0 1", "no colour"),
        ("1.2 0.5 0 1", "1 0.5 0 1", "no colour"),
        ("0,5 1 0 1", "0.5 1 0 1", "no colour"),
        ("0 \u22121 0 1", "0 0 0 1", "no colour"),
        ("1 0 0", "1 0 0 1", "black"),
        ("1 0 0 1 1", "0.75 0.75 0.75 1", "black"),
    ],
)
def test_the_colour_that_is_proposed_is_one(rgba, right, follows):
    text = re.sub(r'rgba="[^"]*"', f'rgba="{rgba}"', ARM, count=1)
    (one,) = [one for one in finds(text) if one.rule == "URDF-W23"]
    assert f'Write rgba="{right}":' in one.remedy
    assert follows in one.gazebo


def test_an_inertia_that_is_missing_is_computed_from_the_shape():
    text = re.sub(r"<inertia .*?/>", "", ARM, count=1)
    computed = [one.remedy for one in finds(text) if one.rule == "URDF-E26"]
    assert len(computed) == 1
    mended = re.sub(r"<inertia .*?/>", re.search(r"<inertia .*?/>", computed[0])[0], ARM, count=1)
    assert finds(mended) == []


@pytest.mark.parametrize("end", ["parent", "child"])
def test_the_end_that_a_joint_lacks_is_named(end):
    for match in re.finditer(rf'<{end} link="(\w+)"/>', ARM):
        for rest in ("", f'<{end} link=""/>', f"<{end}/>"):
            (one,) = finds(ARM[: match.start()] + rest + ARM[match.end() :])
            assert f'link="{match[1]}"' in one.remedy
