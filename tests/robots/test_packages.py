"""Each folder is a ROS package, and none of them gets into a student's way."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from simkit.packages import PackagePath
from simkit.xml import Element, parse_xml
from tests.laws import broken_laws

ROBOTS = Path(__file__).resolve().parents[2] / "robots"

PACKAGES = sorted(path.parent.name for path in ROBOTS.glob("*/package.xml"))
NEEDED_ON_NOETIC = "joint_state_publisher_gui"
"""What the parameter use_gui stands for."""


def home_of(plugin: str) -> str:
    """The package of ROS that a library of Gazebo comes in."""
    return "gazebo_ros_control" if plugin == "libgazebo_ros_control.so" else "gazebo_plugins"


def manifest(folder: Path) -> Element:
    root = parse_xml((folder / "package.xml").read_bytes(), file="package.xml").root
    assert root is not None
    return root


def packages_named_in(folder: Path) -> set[str]:
    text = "\n".join(path.read_text() for path in sorted(folder.glob("*/*.*")))
    plugins = re.findall(r'filename="(\w+\.so)"', text)
    patterns = (r'pkg="(\w+)"', r"\$\(find (\w+)\)", r'type: "(\w+)/')
    named = {name for pattern in patterns for name in re.findall(pattern, text)}
    return (named | set(map(home_of, plugins))) - {folder.name}


def test_every_folder_is_a_package(packages):
    folders = {path.name for path in ROBOTS.iterdir() if path.is_dir()} - {"pictures"}
    broken_laws(
        sorted(folders.symmetric_difference(packages.packages())),
        "each folder in robots/ has a package.xml with the name of the folder",
    )


@pytest.mark.parametrize("name", PACKAGES)
def test_a_manifest_names_what_the_files_use(robots, name):
    says = manifest(robots / name)
    needed = [one.text for one in says.all("exec_depend")]
    assert [one.text for one in says.all("name")] == [name]
    assert needed == sorted(set(needed))
    wrong = (set(needed) - {NEEDED_ON_NOETIC}) ^ packages_named_in(robots / name)
    broken_laws(
        sorted(wrong), f"an <exec_depend> in {name}/package.xml for each package that is used"
    )


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
