"""Packages on disk, and the file that a command line means."""

import os

import pytest

from simkit.errors import UnknownNameError
from simkit.packages import PackageError, PackagePath


@pytest.fixture
def make(tmp_path):
    """A function that makes a file below a folder of its own, parents and all."""

    def make(path, text="", mode=0o644):
        file = tmp_path / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        file.chmod(mode)
        return file

    make.folder = tmp_path
    return make


@pytest.fixture
def path(make):
    return PackagePath([make.folder])


def test_a_folder_with_a_manifest_is_a_package_however_deep(make, path):
    make("one/package.xml")
    make("src/course/two/package.xml")
    make("plain/scripts/x.py")
    found = path.packages()
    assert sorted(found) == ["one", "two"]
    assert found["two"].folder == make.folder / "src/course/two"
    assert path.find("one").name == "one"


def test_a_package_in_a_package_is_none(make, path):
    make("outer/package.xml")
    make("outer/inner/package.xml")
    assert list(path.packages()) == ["outer"]


def test_the_path_itself_may_be_the_package(make):
    make("robot/package.xml")
    assert list(PackagePath([make.folder / "robot"]).packages()) == ["robot"]


@pytest.mark.parametrize("folder", [".venv", ".git", "__pycache__", "a/b/c/d/e/f"])
def test_some_folders_are_not_looked_into(make, path, folder):
    make(f"{folder}/hidden/package.xml")
    assert path.packages() == {}


def test_a_folder_that_asks_for_it_is_passed_over_unless_it_is_named(make, path):
    make("robots/CATKIN_IGNORE")
    make("robots/arm/package.xml")
    make("work/arm/package.xml")
    assert path.find("arm").folder == make.folder / "work/arm"
    robots = PackagePath([make.folder / "robots"])
    assert robots.find("arm").folder == make.folder / "robots/arm"


def test_links_are_not_followed(make, path):
    make("one/package.xml")
    (make.folder / "link").symlink_to(make.folder / "one")
    (make.folder / "loop").symlink_to(make.folder)
    assert list(path.packages()) == ["one"]


def test_the_first_folder_of_the_path_wins(make, monkeypatch):
    make("first/robot/package.xml")
    make("second/robot/package.xml")
    make("third/robot/package.xml")
    make("third/arm/package.xml")
    folders = [make.folder / name for name in ("first", "second", "third")]
    monkeypatch.setenv("SIMKIT_PACKAGE_PATH", f"{os.pathsep}{folders[2]}{os.pathsep}")
    path = PackagePath(folders[:2])
    assert path.find("robot").folder == folders[0] / "robot"
    assert path.find("arm").folder == folders[2] / "arm"


def test_a_folder_of_the_path_that_is_not_there_has_no_packages(make):
    assert PackagePath([make.folder / "nowhere"]).packages() == {}


def test_without_folders_the_working_folder_is_meant(make, monkeypatch):
    make("robot/package.xml")
    monkeypatch.chdir(make.folder)
    monkeypatch.delenv("SIMKIT_PACKAGE_PATH", raising=False)
    path = PackagePath()
    monkeypatch.chdir("/")
    assert list(path.packages()) == ["robot"]


def test_an_unknown_package_names_near_ones(make, path):
    make("hello_ros/package.xml")
    with pytest.raises(UnknownNameError, match="did you mean 'hello_ros'"):
        path.find("helo_ros")


def test_a_folder_without_manifest_is_told_what_it_lacks(make, path):
    make("robot/scripts/x.py")
    with pytest.raises(PackageError, match=r"robot/package\.xml"):
        path.find("robot")


def test_an_executable_is_found_by_its_name_anywhere(make, path):
    make("robot/package.xml")
    file = make("robot/deep/down/drive.py")
    program = make("robot/bin/drive", mode=0o755)
    package = path.find("robot")
    assert package.find_executable("drive.py") == file
    assert package.find_executable("drive") == program


def test_an_executable_that_is_not_there_lists_what_could_be_run(make, path):
    make("robot/package.xml")
    make("robot/scripts/drive.py")
    make("robot/bin/tool", mode=0o755)
    make("robot/notes.txt")
    with pytest.raises(UnknownNameError, match=r"did you mean 'drive\.py'") as caught:
        path.find("robot").find_executable("drvie.py")
    assert caught.value.known == ("drive.py", "tool")


def test_two_files_of_one_name_are_no_answer(make, path):
    make("robot/package.xml")
    make("robot/scripts/drive.py")
    make("robot/old/drive.py")
    with pytest.raises(PackageError, match=r"old/drive\.py, scripts/drive\.py"):
        path.find("robot").find_executable("drive.py")


def test_where_nothing_is_confined_any_file_may_be_read(make, path):
    assert path.may_read("/anything")


def test_confined_only_the_files_of_packages_may_be_read(make, monkeypatch):
    make("ws/robot/package.xml")
    make("ws/loose.txt")
    make("elsewhere/package.xml")
    make("ws/robot/urdf/r.urdf")
    (make.folder / "ws/robot/link").symlink_to(make.folder / "ws/loose.txt")
    (make.folder / "ws/robot/self").symlink_to(make.folder / "ws/robot/self")
    (make.folder / "door").symlink_to(make.folder / "ws/robot")
    monkeypatch.setenv("SIMKIT_PACKAGE_PATH", str(make.folder / "elsewhere"))
    confined = PackagePath([make.folder / "ws"], confined=True)
    robot = make.folder / "ws/robot"
    for inside in ("urdf/r.urdf", "not/there", "urdf/../urdf/r.urdf", "../robot/x"):
        assert confined.may_read(robot / inside), inside
    assert confined.may_read(make.folder / "door/urdf/r.urdf")
    for outside in ("../loose.txt", "link", "self", "urdf/../../loose.txt", "/etc/passwd", "a\0b"):
        assert not confined.may_read(robot / outside), outside
    assert not confined.may_read(make.folder / "elsewhere/package.xml")
    assert list(confined.packages()) == ["robot"]


def test_folders_may_be_preferred_later(tmp_path):
    for folder in ("one", "two"):
        (tmp_path / folder / "play").mkdir(parents=True)
        (tmp_path / folder / "play/package.xml").write_text("<package/>")
    path = PackagePath([tmp_path / "one"])
    path.prefer([tmp_path / "two", tmp_path / "none"])
    assert path.find("play").folder == tmp_path / "two/play"
    path.prefer([tmp_path / "one"])
    assert path.find("play").folder == tmp_path / "one/play"
    assert len(path.folders) == len(set(path.folders))
