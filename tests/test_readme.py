"""What README and the other texts show is so: the program runs, lists and pictures are fresh."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from itertools import chain
from pathlib import Path

import pytest
from matplotlib.image import imread

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
TEXTS = [
    *("README.md", "CONTRIBUTING.md", "CONVENTIONS.md", "CHANGELOG.md"),
    *("docs/architecture.md", "docs/differences_from_gazebo.md", "robots/README.md"),
]
PROGRAM_LINES = 15


def blocks(language: str) -> list[str]:
    return re.findall(rf"```{language}\n(.*?)```", README, re.DOTALL)


def python(*arguments: str, folder: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments], cwd=folder, capture_output=True, text=True, check=False
    )


def test_the_program_prints_what_readme_shows_and_draws_its_picture(tmp_path: Path) -> None:
    program, shown = blocks("python")[0], blocks("text")[0]
    assert len(program.splitlines()) <= PROGRAM_LINES
    done = python("-W", "error", "-c", program, folder=tmp_path)
    assert (done.stdout, done.stderr) == (shown, "")
    drawn = (tmp_path / "turtles.svg").read_bytes()
    assert drawn == (ROOT / "docs/pictures/turtles.svg").read_bytes()


def test_the_robot_goes_where_readme_says_and_looks_as_its_picture(tmp_path: Path) -> None:
    (tmp_path / "robots").symlink_to(ROOT / "robots")
    program, shown = blocks("python")[1], blocks("text")[2]
    assert len(program.splitlines()) <= PROGRAM_LINES
    done = python("-W", "error", "-c", program, folder=tmp_path)
    assert (done.stdout, done.stderr) == (shown, "")
    assert (tmp_path / "drive.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    # Another processor may round in another way: pixels at an edge may differ.
    drawn, kept = imread(tmp_path / "world.png"), imread(ROOT / "docs/pictures/world.png")
    assert drawn.shape == kept.shape
    assert float(abs(drawn - kept).mean()) < 0.01


FAULTY_ARM = """\
<?xml version="1.0"?>
<robot name="arm">
  <link name="base_link"/>
  <link name="arm">
    <visual>
      <geometry>
        <cylinder length="0.4" radius="0.05"/>
      </geometry>
    </visual>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base_link"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-90" upper="90" effort="10" velocity="1"/>
  </joint>
</robot>
"""


def test_check_urdf_says_what_readme_shows(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(FAULTY_ARM, encoding="utf-8")
    done = python("-m", "simkit.cli", "check_urdf", "arm.urdf", folder=tmp_path)
    assert done.stdout.startswith("robot name is: arm\n")
    # README shows what a terminal of its width shows; a pipe gets the first line in one piece.
    assert " ".join(blocks("text")[1].split()) in " ".join(done.stderr.split())


@pytest.mark.parametrize("script", ["docs/pictures/make_pictures.py", "docs/exercise_list.py"])
def test_what_is_generated_is_fresh(script: str) -> None:
    done = python(script, "--check", folder=ROOT)
    assert (done.stdout, done.stderr, done.returncode) == ("", "", 0)


def test_the_list_of_exercises_follows_the_sources(tmp_path: Path) -> None:
    for name in ("docs", "solutions"):
        (tmp_path / name).mkdir()
    source = ROOT / "solutions/3_01_broadcast_a_tf.md"
    text = source.read_text(encoding="utf-8").replace('id: "3.1"', 'id: "3.9"')
    (tmp_path / "solutions/3_09_another_one.md").write_text(text, encoding="utf-8")
    (tmp_path / "README.md").write_text(README, encoding="utf-8")
    script = tmp_path / "docs/exercise_list.py"
    script.write_bytes((ROOT / "docs/exercise_list.py").read_bytes())
    assert python(str(script), "--check", folder=tmp_path).returncode == 1
    assert python(str(script), folder=tmp_path).returncode == 0
    written = (tmp_path / "README.md").read_text(encoding="utf-8")
    assert "| 3.9 | [Broadcast the turtle's pose as a transform]" in written
    assert "| 3.1 |" not in written
    assert written.partition("## Who")[2] == README.partition("## Who")[2]


def test_the_page_of_the_architecture_says_why_each_library_is_there() -> None:
    page = (ROOT / "docs/architecture.md").read_text(encoding="utf-8").lower()
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    listed = [*project["dependencies"], *chain(*project["optional-dependencies"].values())]
    names = [re.match(r"[\w-]+", line)[0].lower() for line in listed]
    broken_laws(
        [name for name in names if name not in page],
        "give it a row in the table of libraries in docs/architecture.md: what it does, and why not another",
    )


@pytest.mark.parametrize("package", ["simkit", "grader"])
def test_the_page_of_the_architecture_has_a_row_for_each_folder(package: str) -> None:
    page = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
    folders = {path.parent.name for path in (ROOT / package).glob("*/__init__.py")}
    if package == "simkit":
        folders.add("ros1")
    broken_laws(
        sorted(name for name in folders if f"`{name}/`" not in page),
        "give it a row in the tables of docs/architecture.md: what it is, and what to read first",
    )


@pytest.mark.parametrize("text", TEXTS)
def test_links_and_pictures_lead_somewhere(text: str) -> None:
    path = ROOT / text
    targets = re.findall(r"\]\(([^)#]+)[^)]*\)|src=\"([^\"]+)\"", path.read_text(encoding="utf-8"))
    local = ["".join(pair) for pair in targets if not "".join(pair).startswith("https://")]
    assert [target for target in local if not (path.parent / target).exists()] == []


@pytest.mark.parametrize("text", TEXTS)
def test_files_named_in_texts_exist(text: str) -> None:
    named = re.findall(
        r"`((?:docs|simkit|grader|tests|solutions|exercises|\.ci)/[\w/.-]+)`",
        (ROOT / text).read_text(encoding="utf-8"),
    )
    made_up = re.compile(r"3_11|<|gradebook|PACKAGE|NAME")
    assert [n for n in named if not made_up.search(n) and not (ROOT / n).exists()] == []
