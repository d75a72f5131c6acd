from __future__ import annotations

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.submission.paths import Placed, place

WANTED = ("hello_ros/scripts/listener.py", "hello_ros/launch/start.launch")


def placed(path: str) -> Placed:
    return place(path, packages={"hello_ros"}, wanted=WANTED)


@pytest.mark.parametrize(
    "path", ["hello_ros/scripts/listener.py", "./hello_ros//scripts/./listener.py"]
)
def test_a_deliverable_is_placed_without_a_note(path: str) -> None:
    assert placed(path) == Placed(path="hello_ros/scripts/listener.py")


@pytest.mark.parametrize(
    "path",
    [
        "hello_ros\\scripts\\listener.py",
        "work/hello_ros/scripts/listener.py",
        "Hello_ROS/scripts/Listener.py",
    ],
)
def test_an_honest_slip_is_placed_with_a_note(path: str) -> None:
    found = placed(path)
    assert found.path == "hello_ros/scripts/listener.py"
    assert "write it so" in found.note


@pytest.mark.parametrize("path", ["hello_ros/scripts/my_tools.py", "hello_ros/package.xml"])
def test_another_file_of_the_package_is_taken(path: str) -> None:
    assert placed(path) == Placed(path=path)


@pytest.mark.parametrize(
    ("path", "says"),
    [
        ("", "no name"),
        ("./", "no name"),
        ("/etc/passwd", "relative"),
        ("~/x.py", "relative"),
        ("C:\\x.py", "relative"),
        ("../x.py", r"`\.\.`"),
        ("hello_ros/../../x.py", r"`\.\.`"),
        ("hello_ros\\..\\..\\x.py", r"`\.\.`"),
        ("hello_ros/scripts/", "folder"),
        ("hello_ros/{name}.py", "plain name"),
        ("hello_ros/$NAME.py", "plain name"),
        ("hello_ros/a\x00b.py", "plain name"),
        ("hello_ros/a\u202eb.py", "plain name"),
        ("hello_ros/nul.py", "plain name"),
        ("hello_ros/ x.py", "plain name"),
        ("hello_ros/" + "x" * 300, "longer than"),
        ("turtlesim/package.xml", "files are in hello_ros/"),
        ("hello_ros/turtlesim/package.xml", "a package in a package"),
        ("rospy.py", "files are in hello_ros/"),
        ("listener.py", "write it as hello_ros/scripts/listener.py"),
    ],
)
def test_any_other_path_is_refused_with_a_sentence(path: str, says: str) -> None:
    found = placed(path)
    assert found.path is None
    assert re.search(says, found.note)


@given(
    st.text(max_size=60)
    | st.lists(st.sampled_from(["..", "/", "\\", "hello_ros", "~", ".", "a"])).map("".join)
)
@settings(deadline=None)
def test_no_path_leads_out_of_the_package(path: str) -> None:
    found = placed(path)
    if found.path is None:
        assert found.note
    else:
        parts = found.path.split("/")
        assert parts[0] == "hello_ros"
        assert not {"", ".", ".."} & set(parts)
