"""xacro in a process of its own."""

import pytest

from simkit.packages import PackagePath
from simkit.urdf import load_robot
from simkit.xacro import XacroError, run_xacro
from simkit.xacro import run as module

ARM = """<?xml version="1.0"?>
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="links" default="3"/>
  <xacro:macro name="chain" params="n">
    <link name="link_${n}"/>
    <xacro:if value="${n > 0}">
      <joint name="joint_${n}" type="fixed">
        <parent link="link_${n}"/> <child link="link_${n - 1}"/> <origin rpy="0 0 ${pi / n}"/>
      </joint>
      <xacro:chain n="${n - 1}"/>
    </xacro:if>
  </xacro:macro>
  <xacro:chain n="$(arg links)"/>
</robot>
"""


@pytest.fixture
def write(tmp_path):
    """A function that writes a file, and gives its path."""

    def write(text, name="robot.xacro"):
        (tmp_path / name).write_text(text)
        return str(tmp_path / name)

    return write


@pytest.fixture
def packages(tmp_path):
    return PackagePath([tmp_path])


def test_macros_become_a_robot(write, packages):
    path = write(ARM)
    output = run_xacro([path, "links:=5"], packages=packages)
    robot = load_robot(output.text, file="arm.urdf")
    assert robot.root == "link_5"
    assert len(robot.links) == 6
    assert run_xacro([path, "links:=5"], packages=packages) == output


def test_it_can_write_a_file(write, packages, tmp_path):
    output = run_xacro([write(ARM), "-o", str(tmp_path / "arm.urdf")], packages=packages)
    assert output.text == ""
    assert "link_3" in (tmp_path / "arm.urdf").read_text()


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("<robot name='${x}'/>", "name 'x' is not defined, when evaluating expression 'x'"),
        ("<robot", "XML parsing error: unclosed token: line 1, column 0"),
        ("<robot name='${\"a\" * 10**11}'/>", "this is too much, when evaluating"),
        ("<robot name='${().__class__}'/>", "Use of invalid name"),
        ("<robot name='$(find nothing)'/>", "there is no package 'nothing'; there are: none"),
        (ARM.replace('value="${n > 0}"', 'value="1"'), "division by zero"),
        (ARM.replace('value="${n > 0}"', 'value="1"').replace("pi / n", "0"), "recursion"),
    ],
)
def test_what_is_wrong_is_told_in_one_line(write, packages, text, what):
    with pytest.raises(XacroError) as refused:
        run_xacro([write(text)], packages=packages)
    assert what in str(refused.value)
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 1000
    assert refused.value.exit_code == 2


def test_a_file_that_is_not_there(packages, tmp_path):
    missing = tmp_path / "missing.xacro"
    with pytest.raises(XacroError, match=f"No such file or directory: {missing}$"):
        run_xacro([str(missing)], packages=packages)


def test_one_that_computes_for_ever_is_ended(write, packages, monkeypatch):
    monkeypatch.setattr(module, "TIMEOUT", 1.0)
    with pytest.raises(XacroError, match="has not come to an end"):
        run_xacro([write("<robot name='${9**9**9}'/>")], packages=packages)
