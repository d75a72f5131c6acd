"""One slip of the pen is one find: not its consequences, too."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from simkit.diagnostics import Diagnostic, Severity
from simkit.packages import PackagePath
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

ARM = (Path(__file__).parents[1] / "faults/planted/00_clean.urdf").read_text("utf-8")


def finds(text: str) -> list[Diagnostic]:
    found = check_robot(parse_xml(text, file="arm.urdf"))
    return [one for one in found if one.severity is not Severity.NOTE]


def without(pattern: str) -> Iterator[str]:
    """The arm without one match of a pattern, or of its group, after the other; never without that of the robot."""
    for match in re.finditer(pattern, ARM):
        if "robot" not in match[0]:
            start, end = match.span(match.re.groups)
            yield ARM[:start] + ARM[end:]


SLIPS = {
    "a start tag lost": without(r"<(?!material name)\w[^<>]*[^/?]>"),
    "an end tag lost": without(r"</\w+>"),
    "the slash of a tag lost": without(r"(/)>"),
    "a quotation mark lost": without(r"\""),
    "a letter of a tag lost": without(r"<\w(\w)\w"),
    "a letter of an attribute lost": without(r" \w(\w)\w+="),
    "a letter of a link's name lost at its joint": without(r"link=\"\w(\w)"),
    "a letter of a type lost": without(r"type=\"\w(\w)"),
}


@pytest.mark.parametrize("slip", SLIPS)
def test_one_slip_is_one_find(slip):
    texts = list(SLIPS[slip])
    assert len(texts) > 1
    counts = [len(finds(text)) for text in texts]
    assert counts == [1] * len(texts)


@pytest.mark.parametrize("tag", ["</visual>", "</collision>", "</link>", "</joint>", "</geometry>"])
def test_an_end_tag_twice_is_one_find(tag):
    for match in re.finditer(tag, ARM):
        assert len(finds(ARM[: match.end()] + tag + ARM[match.end() :])) == 1


def test_a_start_tag_twice_is_one_find():
    for match in re.finditer(r"<(?!robot)\w[^<>]*[^/?]>", ARM):
        (one,) = finds(ARM[: match.end()] + "\n" + match[0] + ARM[match.end() :])
        assert one.rule == "URDF-E01"
        assert one.what.endswith("and only one of the two is closed")


def test_a_lost_gazebo_is_named():
    inside = "    <material>Gazebo/Red</material>\n    <mu1>1</mu1>\n"
    block = f'  <gazebo reference="torso">\n{inside}  </gazebo>\n'
    text = ARM.replace("</robot>", f"{block}</robot>")
    assert finds(text) == []
    found = finds(text.replace('  <gazebo reference="torso">\n', ""))
    assert "</gazebo> closes nothing: no <gazebo> is open here" in [one.what for one in found]


def test_meshes_of_a_package_that_is_not_there_are_one_find(tmp_path):
    mesh = '<geometry><mesh filename="package://far_away/meshes/{}.stl"/></geometry>'
    numbers = iter(range(100))
    text = re.sub(
        r"<geometry>.*?</geometry>", lambda _: mesh.format(next(numbers)), ARM, flags=re.S
    )
    count = next(numbers)
    found = check_robot(parse_xml(text, file="arm.urdf"), packages=PackagePath([tmp_path]))
    (one,) = [one for one in found if one.rule == "URDF-E18"]
    assert one.severity is Severity.WARNING
    assert f"nor {count - 1} more of that package: no package 'far_away'" in one.what


@pytest.mark.parametrize("written", ["xzy", "zyx", "ryp", "pry"])
def test_letters_that_changed_places_are_one_slip(written):
    meant = "xyz" if "x" in written else "rpy"
    (one,) = [
        one for one in finds(ARM.replace(f" {meant}=", f" {written}=", 1)) if one.rule == "URDF-W17"
    ]
    assert one.remedy.startswith(f'Did you mean {meant}="')


def test_two_slips_are_two_finds():
    text = ARM.replace("<geometry>", "", 1).replace('type="revolute"', 'type="revolut"')
    assert [one.rule for one in finds(text)] == ["URDF-E01", "URDF-E20"]


def test_a_link_called_otherwise_is_told_where_it_is_asked_for_once():
    (one,) = finds(ARM.replace('<link name="torso"', '<link name="troso"'))
    assert one.rule == "URDF-E02"
    assert one.what.endswith("and 1 more joint asks for it")
    assert 'call it name="torso" in line 35' in one.remedy
