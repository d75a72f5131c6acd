"""The page of the robots: fresh, honest, and quick to say when it is not."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

COMMAND = "docs/robots/make_pages.py"


def make_pages(folder: Path, *arguments: str) -> tuple[str, int]:
    command = [sys.executable, "-W", "error", COMMAND, *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    return done.stdout + done.stderr, done.returncode


@pytest.fixture
def one_robot(root, tmp_path):
    """A workbook with the script and a single robot, the smallest."""
    shutil.copytree(
        root / "docs/robots", tmp_path / "docs/robots", ignore=shutil.ignore_patterns("__pycache__")
    )
    shutil.copytree(root / "robots", tmp_path / "robots")
    keep = tmp_path / "robots/hello_ros/urdf/hello_ros_robot_1.urdf"
    for path in tmp_path.glob("robots/*/urdf/*.urdf"):
        if path != keep:
            path.unlink()
    return keep


def test_the_page_and_its_pictures_are_fresh(root):
    assert make_pages(root, "--check") == ("", 0)


def test_a_change_of_a_robot_makes_them_stale(one_robot):
    folder = one_robot.parents[3]
    said, code = make_pages(folder)
    assert (said, code) == (
        "wrote robots/README.md\n",
        0,
    )  # the others are gone, its pictures are those it had
    text = one_robot.read_text()
    one_robot.write_text(text.replace('radius="0.1"', 'radius="0.15"'))
    said, code = make_pages(folder, "--check")
    assert code == 1
    assert re.findall(r"^(\S+) is stale", said, re.MULTILINE) == [
        "robots/README.md",
        "robots/pictures/hello_ros_robot_1.png",
    ]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("</link>", "</link></link>", "check_urdf says"),
        ('rpy="0 0 0"', 'rpy="0 0 90"', "check_urdf finds 1 warning"),
    ],
)
def test_there_is_no_page_for_a_robot_that_is_not_clean(one_robot, old, new, words):
    text = one_robot.read_text()
    one_robot.write_text(text.replace(old, new, 1))
    said, code = make_pages(one_robot.parents[3], "--check")
    assert code == 1
    assert words in said
    assert "Traceback" not in said


def test_a_robot_without_an_exercise_stands_last(root, one_robot):
    folder = one_robot.parents[3]
    new = folder / "robots/hello_ros/urdf/a_new_one.urdf"
    new.write_text(one_robot.read_text().replace("Exercise 3.6", "No exercise"))
    assert make_pages(folder)[1] == 0
    page = (folder / "robots/README.md").read_text(encoding="utf-8")
    assert re.findall(r"^#### (\S+)$", page, re.MULTILINE)[-1] == new.name


def test_every_robot_has_a_section_and_every_picture_a_robot(root, robots):
    page = (robots / "README.md").read_text(encoding="utf-8")
    names = {path.name for path in robots.glob("*/urdf/*.urdf")}
    assert set(re.findall(r"^#### (\S+)$", page, re.MULTILINE)) == names
    shown = set(re.findall(r"\]\(pictures/([^)]+)\)", page))
    assert shown == {path.name for path in (robots / "pictures").iterdir()}
    assert len(shown) == 2 * len(names)


def test_the_facts_of_the_book_are_on_the_page(robots):
    page = (robots / "README.md").read_text(encoding="utf-8")
    car = page.partition("#### practice_car.urdf")[2]
    assert "| mass | 2.5 kg |" in car
    assert "| centre of mass | (-0.02, 0, 0.14) m in `base_link` |" in car
    arm = page.partition("#### hello_gazebo_robot_1.urdf")[2].partition("####")[0]
    assert "| mass | 3 kg |" in arm
    assert "| size | 0.5 x 0.25 x 0.55 m |" in arm
    assert page.count("no errors, no warnings") == page.count("#### ")
