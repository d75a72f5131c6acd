"""Each folder is a ROS package, and none of them gets into a student's way."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.packages import PackagePath
from simkit.xml import Element, parse_xml

PACKAGES = ["gazebo_car", "hello_ros", "my_robot_urdf"]
LIVES_IN = {
    "libgazebo_ros_control.so": "gazebo_ros_control",
    "libgazebo_ros_diff_drive.so": "gazebo_plugins",
    "libgazebo_ros_joint_state_publisher.so": "gazebo_plugins",
    "libgazebo_ros_laser.so": "gazebo_plugins",
}
NEEDED_ON_NOETIC = "joint_state_publisher_gui"
"""What the parameter use_gui stands for."""


def manifest(folder: Path) -> Element:
    root = parse_xml((folder / "package.xml").read_bytes(), file="package.xml").root
    assert root is not None
    return root


def packages_named_in(folder: Path) -> set[str]:
    text = "\n".join(path.read_text() for path in sorted(folder.glob("*/*.*")))
    plugins = re.findall(r'filename="(\w+\.so)"', text)
    patterns = (r'pkg="(\w+)"', r"\$\(find (\w+)\)", r'type: "(\w+)/')
    named = {name for pattern in patterns for name in re.findall(pattern, text)}
    return (named | {LIVES_IN[plugin] for plugin in plugins}) - {folder.name}


def test_every_folder_is_a_package(packages):
    assert sorted(packages.packages()) == PACKAGES


@pytest.mark.parametrize("name", PACKAGES)
def test_a_manifest_names_what_the_files_use(robots, name):
    told = manifest(robots / name)
    needed = [one.text for one in told.all("exec_depend")]
    assert [one.text for one in told.all("name")] == [name]
    assert needed == sorted(set(needed))
    assert set(needed) - {NEEDED_ON_NOETIC} == packages_named_in(robots / name)


@pytest.mark.parametrize("name", PACKAGES)
def test_catkin_installs_every_folder(robots, name):
    cmake = (robots / name / "CMakeLists.txt").read_text()
    folders = sorted(path.name for path in (robots / name).iterdir() if path.is_dir())
    assert f"project({name})" in cmake
    assert f"DIRECTORY {' '.join(folders)}\n" in cmake


def test_whoever_works_in_the_folder_of_the_workbook_does_not_meet_them(root, robots):
    assert PackagePath([robots]).find("hello_ros").folder == robots / "hello_ros"
    met = PackagePath([root]).packages().values()
    assert [one.folder for one in met if one.folder.is_relative_to(robots)] == []


def test_nothing_that_a_student_opens_leads_to_them(root):
    opened = [*root.glob("exercises/*"), *root.glob("lectures/*")]
    assert opened
    texts = {path.name: path.read_text(encoding="utf-8") for path in opened if path.is_file()}
    assert [name for name, text in texts.items() if re.search(r"\brobots/", text)] == []
