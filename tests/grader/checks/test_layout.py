import os

import pytest

from grader.checks.layout import lay_out
from simkit.packages import PackagePath


def test_files_become_packages_that_are_found(tmp_path):
    folder = tmp_path / "work"
    files = {"hello_ros/scripts/talk.py": "print('ä')\n", "hello_ros/urdf/a.urdf": "<robot/>"}
    lay_out(files, folder, package="hello_ros")
    package = PackagePath([folder]).find("hello_ros")
    script = package.find_executable("talk.py")
    assert script.read_text("utf-8") == "print('ä')\n"
    assert os.access(script, os.X_OK)
    assert not (folder / "hello_ros/urdf/a.urdf").stat().st_mode & 0o111


def test_the_package_of_the_exercise_is_always_there(tmp_path):
    lay_out({}, tmp_path / "work", package="hello_ros")
    assert (tmp_path / "work/hello_ros/package.xml").is_file()


def test_a_students_own_manifest_stays(tmp_path):
    lay_out({"hello_ros/package.xml": "<package/>"}, tmp_path / "work", package="hello_ros")
    assert (tmp_path / "work/hello_ros/package.xml").read_text() == "<package/>"


@pytest.mark.parametrize("path", ["../x.py", "/etc/x.py", "hello_ros/../../x.py"])
def test_a_path_that_leads_out_is_refused(tmp_path, path):
    with pytest.raises(ValueError, match="leads out"):
        lay_out({path: ""}, tmp_path / "work", package="hello_ros")
    assert not (tmp_path / "x.py").exists()
