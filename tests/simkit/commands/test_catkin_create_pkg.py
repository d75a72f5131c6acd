from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import pytest

from simkit import Simulation
from simkit.commands.catkin_create_pkg import create_package
from simkit.packages import PackageError


def test_what_is_made(tmp_path):
    made = create_package("hello_ros", ["rospy", "tf", "rospy"], folder=tmp_path)
    assert str(made).splitlines() == [
        "Created file hello_ros/CMakeLists.txt",
        "Created file hello_ros/package.xml",
        "Created folder hello_ros/launch",
        "Created folder hello_ros/scripts",
        "Created folder hello_ros/urdf",
        f"Successfully created files in {tmp_path / 'hello_ros'}. "
        "Please adjust the values in package.xml.",
    ]
    manifest = ElementTree.parse(tmp_path / "hello_ros" / "package.xml").getroot()
    assert manifest.findtext("name") == "hello_ros"
    assert [one.text for one in manifest.findall("depend")] == ["rospy", "tf"]
    cmake = (tmp_path / "hello_ros" / "CMakeLists.txt").read_text()
    assert "project(hello_ros)" in cmake
    assert "find_package(catkin REQUIRED COMPONENTS\n  rospy\n  tf\n)" in cmake


def test_without_dependencies_and_in_the_working_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made = create_package("lab", description="Wheels & arms")
    assert made.folder == tmp_path / "lab"
    assert "find_package(catkin REQUIRED)\n" in (made.folder / "CMakeLists.txt").read_text()
    manifest = ElementTree.parse(made.folder / "package.xml").getroot()
    assert manifest.findtext("description") == "Wheels & arms"


def test_a_node_in_it_runs(tmp_path):
    made = create_package("lab", ["rospy"], folder=tmp_path)
    (made.folder / "scripts" / "hello.py").write_text("print('hello')\n")
    with Simulation(package_path=[tmp_path], screen=None) as sim:
        node = sim.rosrun("lab", "hello.py")
        sim.run(0.1)
        assert node.output == "hello\n"


def test_a_dependency_that_may_be_misspelt_is_noted(tmp_path):
    made = create_package("lab", ["geometry_msg", "rospy", "my_own"], folder=tmp_path)
    assert made.notes == (
        "geometry_msg is no package that simkit knows; did you mean geometry_msgs?",
        "my_own is no package that simkit knows",
    )
    assert "Note: geometry_msg is no package" in str(made)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("Hello-ROS", "'Hello-ROS' is not a valid name for a package: small letters, digits and"),
        ("Hello-ROS", "how about hello_ros?"),
        ("2wheels", "how about wheels?"),
        ("../escape", "how about escape?"),
        ("", "'' is not a valid name for a package"),
        ("hello\n", "how about hello?"),
        ("turtlesim", "turtlesim is a package of ROS, and yours would hide it"),
        ("tf2_ros", "take another name, my_tf2_ros"),
        ("rospy", "rospy is a package of ROS"),
    ],
)
def test_names_that_are_refused(tmp_path, name, text):
    with pytest.raises(PackageError) as caught:
        create_package(name, folder=tmp_path)
    assert text in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_a_dependency_is_a_name_too(tmp_path):
    with pytest.raises(PackageError, match="not a valid name for a dependency"):
        create_package("lab", ["</depend>"], folder=tmp_path)


def test_nothing_that_exists_is_touched(tmp_path):
    create_package("lab", folder=tmp_path)
    before = (tmp_path / "lab" / "package.xml").read_bytes()
    with pytest.raises(PackageError, match="put your scripts into lab/scripts"):
        create_package("lab", ["tf"], folder=tmp_path)
    assert (tmp_path / "lab" / "package.xml").read_bytes() == before
    (tmp_path / "notes").mkdir()
    with pytest.raises(PackageError, match="is there already, but is no package"):
        create_package("notes", folder=tmp_path)
