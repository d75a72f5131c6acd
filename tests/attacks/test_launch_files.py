"""Launch files that want to read or do what is not theirs; the check shouts all that it finds on the parameter server."""

import json

import pytest

from grader.exercises import get_exercise
from grader.run import TimeLimits, grade_submission
from grader.sandbox import Sandbox
from grader.submission import Submission

FILE = "hello_ros/launch/a.launch"
SECRET = "hidden-secret-4712"
DEFINITION = {
    "id": "9.2",
    "title": "Launch",
    "package": "hello_ros",
    "files": [FILE],
    "answers": [],
    "nodes_may": {
        "publish": [],
        "services": [],
        "parameters": ["/free"],
        "launch": ["turtlesim/turtlesim_node"],
    },
}
CHECKS = f'''
from grader.checks import CheckFailed
SECRET = "{SECRET}"

def test_shouts(sim, roslaunch):
    """It launches."""
    roslaunch("a.launch")
    sim.run(1.0)
    raise CheckFailed(f"{{sim.params.get('/')}} {{sim.nodes()}} {{sorted(sim.topics())}}")
'''


READS = (
    '<param name="free" textfile="{checks}"/>',
    '<param name="free" textfile="$(find hello_ros)/../../../../../../../../..{checks}"/>',
    '<param name="free" textfile="/etc/passwd"/>',
    '<param name="free" value="$(env SECRET_TOKEN)"/>',
)
MORE_READS = (
    '<param name="free" command="cat {checks}"/>',
    '<param name="free" textfile="$(find hello_ros)/../../../{checks}"/>',
    '<rosparam param="free" file="{checks}"/>',
    '<include file="{checks}"/>',
    '<param name="free" textfile="/proc/self/environ"/>',
    '<param name="free" value="$(optenv SECRET_TOKEN no)"/>',
    "<param name='free' value=\"$(eval env('SECRET_TOKEN'))\"/>",
    "<param name='free' value=\"$(eval open('{checks}').read())\"/>",
    "<param name='free' command=\"sh -c 'cat {checks}'\"/>",
)


def _slow(text):
    return pytest.param(text, marks=pytest.mark.slow)


@pytest.fixture(scope="module")
def root(tmp_path_factory):
    root = tmp_path_factory.mktemp("course")
    (root / "exercises").mkdir()
    (root / "solutions").mkdir()
    source = f"%%writefile {FILE}\n<launch/>\n"
    cell = {"cell_type": "code", "id": "a", "metadata": {}, "outputs": [], "source": source}
    notebook = {
        "cells": [cell],
        "metadata": {"workbook": DEFINITION},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    (root / "exercises/9_02_launch.ipynb").write_text(json.dumps(notebook))
    (root / "exercises/test_9_02.py").write_text(CHECKS)
    return root


@pytest.fixture
def launched(root, launcher):
    """A function that grades a launch file, and gives all that its author would see."""

    def launched(inner, **files):
        submission = Submission(
            student="eve",
            exercise_id="9.2",
            files={FILE: f"<launch>{inner}</launch>", **files},
            answers={},
        )
        return grade_submission(
            submission,
            get_exercise(root, "9.2"),
            hidden=False,
            sandbox=Sandbox(name="none"),
            launcher=launcher,
            limits=TimeLimits(check=15, exercise=30),
        ).dumps()

    return launched


def test_what_is_the_students_own_is_read(launched):
    text = launched(
        '<param name="free" textfile="$(find hello_ros)/words.txt"/>',
        **{"hello_ros/words.txt": "my own words"},
    )
    assert "my own words" in text


@pytest.mark.parametrize("inner", [*READS, *map(_slow, MORE_READS)])
def test_nothing_else_is(launched, root, monkeypatch, inner):
    monkeypatch.setenv("SECRET_TOKEN", SECRET)
    text = launched(inner.format(checks=root / "exercises/test_9_02.py"))
    assert SECRET not in text
    assert "root:" not in text
    assert "PATH=" not in text
    assert '"status": "failed"' in text


def test_an_entity_reads_nothing(launched, root):
    path = root / "exercises/test_9_02.py"
    text = launched(
        "",
        **{
            FILE: f"<!DOCTYPE launch [<!ENTITY x SYSTEM '{path}'>]><launch><param name='free' value='&x;'/></launch>"
        },
    )
    assert SECRET not in text
    assert "LCH-E04" in text


def test_nothing_is_written(launched, tmp_path):
    target = tmp_path / "out.yaml"
    text = launched(f'<rosparam command="dump" file="{target}"/>')
    assert not target.exists()
    assert "writes no files" in text


@pytest.mark.parametrize(
    ("inner", "sentence"),
    [
        (
            '<node name="x" pkg="rostopic" type="rostopic" args="pub /turtle1/cmd_vel '
            'geometry_msgs/Twist {}"/>',
            "starts rostopic/rostopic, which this exercise does not allow",
        ),
        (
            '<node name="x" pkg="tf" type="static_transform_publisher" args="0 0 0 0 0 0 a b 10"/>',
            "starts tf/static_transform_publisher, which this exercise does not allow",
        ),
        ('<param name="/turtlesim/x" value="1"/>', "sets the parameter /turtlesim/x"),
        ('<rosparam command="delete" param="/turtlesim"/>', "sets the parameter /turtlesim"),
    ],
)
def test_nothing_is_done_that_the_exercise_does_not_allow(launched, inner, sentence):
    text = launched('<node name="sim" pkg="turtlesim" type="turtlesim_node"/>' + inner)
    assert sentence in text
    assert "a.launch: this launch file" in text
    assert "'/sim'" in text
    assert "'/x'" not in text


def test_a_launch_file_that_never_ends_is_refused_soon(launched):
    text = launched('<include file="$(dirname)/a.launch"/>')
    assert "includes itself" in text
