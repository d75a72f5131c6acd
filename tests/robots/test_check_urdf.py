"""ROS takes each robot without a word, and the rules find nothing that is worse than a note."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from simkit.diagnostics import Severity
from simkit.urdf import check_urdf_text, read_robot
from simkit.urdf.rules import Companion, CompanionKind, check_robot
from simkit.xml import parse_xml

KNOWN_NOTES = {
    "hello_ros_robot_1": {"URDF-W10"},  # a robot to look at
    "hello_ros_robot_2": {"URDF-W10"},
    "hello_ros_robot_3": {"URDF-W10"},
    "hello_gazebo_robot_1": {"GZ-W13"},  # silver in RViz, Gazebo's own grey there
    "hello_gazebo_robot_2": {"GZ-W13"},
    "m2wr": {"GZ-W06", "GZ-W07", "URDF-I45"},  # its root link is at the hubs, and has a mass
    "practice_car": {"GZ-W07"},
}
COMPANIONS = {
    "hello_ros_robot_1": ["urdf_launch_1.launch"],
    "hello_ros_robot_2": ["urdf_launch_2.launch"],
    "hello_ros_robot_3": ["urdf_launch_3.launch"],
    "hello_gazebo_robot_1": ["spawn_gazebo_1.launch"],
    "hello_gazebo_robot_2": ["spawn_gazebo_2.launch", "controllers_simple.yaml"],
    "m2wr": ["spawn_urdf.launch"],
    "practice_car": [],
}
KNOWN_NOTES_TOGETHER = KNOWN_NOTES | {
    "hello_ros_robot_2": {"URDF-W10", "LCH-W05"},  # use_gui, which ROS Noetic does not read
    "hello_ros_robot_3": {"URDF-W10", "LCH-W05"},
    "hello_gazebo_robot_2": {"GZ-W13", "CTL-I03"},  # Gazebo asks for gains that nobody needs
    "m2wr": {"GZ-W07", "URDF-I45"},  # the launch file lifts it
}


def finds(urdf, packages, companions=()):
    document = parse_xml(urdf.read_bytes(), file=urdf.name)
    found = check_robot(document, packages=packages, companions=companions, folder=urdf.parent)
    return [(one.severity, one.rule) for one in found]


def companions_of(urdf):
    for name in COMPANIONS[urdf.stem]:
        (path,) = urdf.parents[1].glob(f"*/{name}")
        kind = CompanionKind.YAML if path.suffix == ".yaml" else CompanionKind.LAUNCH
        yield Companion(kind=kind, file=name, text=path.read_text())


def test_alone_a_robot_gets_no_more_than_the_notes_that_we_know(urdf, packages):
    found = finds(urdf, packages)
    assert {severity for severity, _ in found} <= {Severity.NOTE}
    assert {rule for _, rule in found} == KNOWN_NOTES[urdf.stem]


def test_nor_together_with_its_launch_file_and_its_controllers(urdf, packages):
    found = finds(urdf, packages, tuple(companions_of(urdf)))
    assert {severity for severity, _ in found} <= {Severity.NOTE}
    assert {rule for _, rule in found} == KNOWN_NOTES_TOGETHER[urdf.stem]


def test_urdfdom_takes_it_without_a_word(urdf):
    out, err, code = check_urdf_text(read_robot(urdf.read_bytes(), file=urdf.name))
    assert (err, code) == ("", 0)
    assert "Successfully Parsed XML" in out


def test_the_real_check_urdf_prints_the_same(urdf):
    program = shutil.which("check_urdf")
    if program is None:
        pytest.skip("urdfdom's check_urdf is not installed: Debian has it in liburdfdom-tools")
    done = subprocess.run([program, urdf], capture_output=True, text=True, timeout=20, check=False)
    ours = check_urdf_text(read_robot(urdf.read_bytes(), file=urdf.name))
    assert (done.stdout, done.stderr, done.returncode) == ours
