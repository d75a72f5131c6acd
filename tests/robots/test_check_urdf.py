"""ROS takes each robot without a word, and the rules find nothing that is worse than a note."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from simkit.diagnostics import Severity
from simkit.urdf import check_urdf_text, read_robot
from simkit.urdf.rules import Companion, CompanionKind, check_robot
from simkit.xml import parse_xml
from tests.laws import broken_laws

ACCEPTED_NOTES = {
    "hello_ros_robot_1": {"URDF-W10"},  # a robot to look at
    "hello_ros_robot_2": {"URDF-W10", "LCH-W05"},  # use_gui, which ROS Noetic does not read
    "hello_ros_robot_3": {"URDF-W10", "LCH-W05"},
    "hello_gazebo_robot_1": {"GZ-W13"},  # silver in RViz, Gazebo's own grey there
    "hello_gazebo_robot_2": {"GZ-W13", "CTL-I03"},  # Gazebo asks for gains that nobody needs
    "m2wr": {"GZ-W06", "GZ-W07", "URDF-I45"},  # its root link is at the hubs, and has a mass
    "practice_car": {"GZ-W07"},
}
"""By robot the rules whose notes are as they should be, alone or with its launch file; the one table of robots."""


def finds(urdf, packages, companions=()):
    document = parse_xml(urdf.read_bytes(), file=urdf.name)
    found = check_robot(document, packages=packages, companions=companions, folder=urdf.parent)
    return [(one.severity, one.rule) for one in found]


def companions_of(urdf):
    """The launch files that name a robot, and the YAML files that these name."""
    texts = {path.name: path.read_text() for path in sorted(urdf.parents[2].glob("*/*/*"))}
    launches = [n for n, text in texts.items() if n.endswith(".launch") and urdf.name in text]
    yamls = [n for n in texts if n.endswith(".yaml") and any(n in texts[one] for one in launches)]
    for kind, names in ((CompanionKind.LAUNCH, launches), (CompanionKind.YAML, yamls)):
        for name in names:
            yield Companion(kind=kind, file=name, text=texts[name])


def test_the_rules_find_no_more_than_notes_that_are_accepted(urdf, packages):
    together = (*finds(urdf, packages), *finds(urdf, packages, tuple(companions_of(urdf))))
    worse = [
        f"{severity.value} {rule}" for severity, rule in together if severity is not Severity.NOTE
    ]
    broken_laws(worse, f"correct {urdf.name}: `simkit check_urdf` says where and how")
    notes = {rule for _, rule in together}
    broken_laws(
        sorted(notes ^ ACCEPTED_NOTES.get(urdf.stem, set())),
        f"correct {urdf.name}, or change its row of ACCEPTED_NOTES in tests/robots/test_check_urdf.py",
    )


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
