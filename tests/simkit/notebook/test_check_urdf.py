"""The line `%check_urdf`."""

from __future__ import annotations

ROBOT = """\
%%writefile hello_ros/robot.urdf
<?xml version="1.0"?>
<robot name="arm">
  <link name="world"/>
  <link name="base_link"/>
  <joint name="fixed" type="fixed">
    <parent link="world"/>
    <child link="base_lnik"/>
  </joint>
</robot>
"""


def test_a_robot_is_checked_and_what_is_wrong_stands_below(cells):
    shown = cells(
        ROBOT,
        "%check_urdf hello_ros/robot.urdf",
        ROBOT.replace("lnik", "link"),
        "%check_urdf package://hello_ros/robot.urdf",
        "%check_urdf hello_ros/robto.urdf",
        "%check_urdf",
    )
    _, refused, _, clean, unknown, nothing = shown
    assert refused.ok
    assert refused.err == ""
    assert "hello_ros/robot.urdf:7:18: error [URDF-E02]" in refused.out
    assert "\x1b" not in refused.out
    assert clean.out.startswith("robot name is: arm\n---------- Successfully Parsed XML")
    assert clean.err == ""
    assert "did you mean robot.urdf?" in unknown.out
    assert "%check_urdf: Expect URDF xml file to parse" in nothing.out + nothing.err
