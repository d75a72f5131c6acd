"""Where the files of meshes are found, and what is said where they are not."""

from __future__ import annotations

import os

import pytest

from simkit.packages import PackagePath
from simkit.urdf import read_robot_file
from simkit.urdf.meshes import MeshFinder


@pytest.fixture
def folder(tmp_path):
    """A package with a mesh, and another mesh outside of it."""
    meshes = tmp_path / "ws" / "hello_ros" / "meshes"
    meshes.mkdir(parents=True)
    (meshes / "hand.stl").write_text("solid hand", encoding="utf-8")
    (tmp_path / "ws" / "hello_ros" / "package.xml").write_text("<package/>", encoding="utf-8")
    (tmp_path / "outside.stl").write_text("solid outside", encoding="utf-8")
    return tmp_path / "ws"


@pytest.fixture
def finder(folder):
    return MeshFinder(folder / "hello_ros", PackagePath([folder]))


def test_each_way_to_name_a_mesh(finder, folder):
    hand = folder / "hello_ros" / "meshes" / "hand.stl"
    names = (
        "package://hello_ros/meshes/hand.stl",
        f"file://{hand.as_posix()}" if os.sep == "/" else f"file:///{hand.as_posix()}",
        "meshes/hand.stl",
        "./meshes/../meshes/hand.stl",
    )
    for name in names:
        path, problem = finder.find(name)
        assert problem == ""
        assert path is not None
        assert path.samefile(hand)


@pytest.mark.parametrize(
    ("name", "problem"),
    [
        ("", "the name of the mesh is empty"),
        (
            "package://hello_ros/meshes/Hand.STL",
            "package hello_ros has no meshes/Hand.STL; there is hand.stl: upper and lower case count",
        ),
        (
            "package://hello_ros/Meshes/hand.stl",
            "package hello_ros has no Meshes/hand.stl; there is meshes: upper and lower case count",
        ),
        (
            "package://hello_ros/meshes/hnd.stl",
            "package hello_ros has no meshes/hnd.stl; did you mean hand.stl?",
        ),
        (
            "package://hello_rose/meshes/hand.stl",
            "no package 'hello_rose'; did you mean 'hello_ros'? Known: hello_ros",
        ),
        ("meshes/zzzzzz.dae", "there is no meshes/zzzzzz.dae beside the URDF"),
        ("meshes", "there is no meshes beside the URDF that is a file: it is a folder"),
        ("file:///zz/hand.stl", "there is no file:///zz/hand.stl"),
        ("meshes\\hand.stl", "meshes\\hand.stl has backslashes; write meshes/hand.stl"),
        (
            "http://example.org/hand.stl",
            "http: does not name a mesh; what does: package://NAME/meshes/FILE, "
            "file:///FOLDER/FILE, or a name relative to the URDF",
        ),
    ],
)
def test_what_is_missing_is_explained(finder, name, problem):
    assert finder.find(name) == (None, problem)


def test_no_file_can_have_some_names(finder):
    for name in ("a\0b", "x" * 5000):
        path, problem = finder.find(name)
        assert path is None
        assert problem


def test_without_packages(folder):
    path, problem = MeshFinder(folder, None).find("package://hello_ros/meshes/hand.stl")
    assert path is None
    assert problem == "package hello_ros was not looked for: no package folders are known here"


def test_nothing_outside_is_read_where_that_is_forbidden(folder):
    inside = folder / "hello_ros"
    confined = MeshFinder(inside, PackagePath([folder], confined=True))
    outside = (folder.parent / "outside.stl").as_posix()
    for name in (
        "../../outside.stl",
        "package://hello_ros/../../outside.stl",
        f"file://{outside}",
    ):
        path, problem = confined.find(name)
        assert path is None
        assert problem.endswith("is outside of the package folders, so it is not read")
    assert confined.find("package://hello_ros/meshes/hand.stl")[1] == ""
    free = MeshFinder(inside, PackagePath([folder]))
    assert free.find("../../outside.stl")[1] == ""


@pytest.mark.skipif(os.name == "nt", reason="links need a privilege on Windows")
def test_a_link_leads_nowhere_that_is_forbidden(folder):
    meshes = folder / "hello_ros" / "meshes"
    (meshes / "link.stl").symlink_to(folder.parent / "outside.stl")
    confined = MeshFinder(folder / "hello_ros", PackagePath([folder], confined=True))
    for name in ("meshes/link.stl", "package://hello_ros/meshes/link.stl"):
        path, problem = confined.find(name)
        assert path is None
        assert problem.endswith("is outside of the package folders, so it is not read")


def test_the_model_has_the_file_or_the_reason(folder):
    urdf = folder / "hello_ros" / "hand.urdf"
    urdf.write_text(
        '<robot name="r"><link name="a">'
        '<visual><geometry><mesh filename="meshes/hand.stl"/></geometry></visual>'
        '<visual><geometry><mesh filename="meshes/foot.stl"/></geometry></visual>'
        "</link></robot>",
        encoding="utf-8",
    )
    robot = read_robot_file(urdf, PackagePath([folder])).robot
    assert robot is not None
    hand, foot = (visual.geometry for visual in robot.links["a"].visuals)
    assert (hand.path.name, hand.problem) == ("hand.stl", "")
    assert (foot.path, foot.problem) == (None, "there is no meshes/foot.stl beside the URDF")
