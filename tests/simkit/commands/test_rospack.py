"""rospack."""

import pytest


@pytest.fixture(autouse=True)
def in_a_workspace(package, monkeypatch):
    monkeypatch.chdir(package.folder)
    monkeypatch.delenv("SIMKIT_PACKAGE_PATH", raising=False)


def test_packages_are_listed_with_their_folders(simkit, package):
    code, out, _ = simkit("rospack", "list")
    assert code == 0
    assert f"play {package.folder / 'play'}\n" in out
    assert "turtlesim (comes with simkit)\n" in out


def test_a_package_is_found(simkit, package):
    assert simkit("rospack", "find", "play") == (0, f"{package.folder / 'play'}\n", "")


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("paly", "did you mean 'play'"),
        ("turtlesmi", "did you mean 'turtlesim'"),
        ("turtlesim", "comes with simkit"),
        ("sensor_msgs", "simkit rosmsg package sensor_msgs"),
    ],
)
def test_what_is_not_found_is_explained(simkit, name, text):
    code, out, err = simkit("rospack", "find", name)
    assert (code, out) == (1, "")
    assert text in err
    assert err.count("\n") == 1


def test_rosversion_reads_the_package(simkit, package):
    manifest = package.folder / "play" / "package.xml"
    assert simkit("rosversion", "play") == (0, "<unversioned>\n", "")
    manifest.write_text("<package><name>play</name><version>1.2.3</version></package>")
    assert simkit("rosversion", "play") == (0, "1.2.3\n", "")
    assert simkit("rosversion", "-d") == (0, "noetic\n", "")
    assert "which package?" in simkit("rosversion")[2]


def test_packages_of_ros_package_path_are_found_after_those_of_simkit(simkit, package, monkeypatch):
    monkeypatch.chdir("/")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(package.folder))
    assert simkit("rospack", "find", "play") == (0, f"{package.folder / 'play'}\n", "")


def test_what_depends_on_what(simkit, package):
    for name, needs in (("arm", "hand rospy"), ("hand", "finger arm"), ("finger", "")):
        folder = package.folder / name
        folder.mkdir()
        depends = "".join(f"<exec_depend>{need}</exec_depend>" for need in needs.split())
        (folder / "package.xml").write_text(
            f"<package><name>{name}</name><!-- <depend>dream</depend> -->{depends}</package>"
        )
    assert simkit("rospack", "depends1", "arm") == (0, "hand\nrospy\n", "")
    assert simkit("rospack", "depends", "arm") == (0, "finger\nhand\nrospy\n", "")
    assert simkit("rospack", "depends-on", "finger") == (0, "arm\nhand\n", "")
    assert "did you mean 'hand'" in simkit("rospack", "depends", "hnad")[2]
