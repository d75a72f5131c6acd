"""Which file was meant by one that is not there."""

import pytest

from simkit.launch import file_search
from simkit.launch.file_search import torn_find
from simkit.packages import PackagePath

RIGHT = "Write $(find arm)/urdf/robot.urdf"


def how_to_name(name, packages, may_read=lambda path: True):
    return file_search.how_to_name(name, packages, may_read=may_read)


@pytest.fixture
def packages(tmp_path):
    for place in ("arm/urdf/robot.urdf", "arm/urdf/twin.urdf", "arm/meshes/twin.urdf"):
        (tmp_path / place).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / place).write_text("<robot/>")
    (tmp_path / "arm/package.xml").write_text("<package><name>arm</name></package>")
    return PackagePath([tmp_path]).packages().values()


@pytest.mark.parametrize(
    "name",
    [
        "$find arm/urdf/robot.urdf",
        "$find arm)/urdf/robot.urdf",
        "$(find arm/urdf/robot.urdf",
        "(find arm)/urdf/robot.urdf",
        "${find arm}/urdf/robot.urdf",
        "find arm/urdf/robot.urdf",
        "$(find arm/urdf/robot.urdf)",
        "$( find arm /urdf/robot.urdf",
    ],
)
def test_a_torn_find_is_mended(name, packages):
    assert how_to_name(name, packages).startswith(f"{RIGHT}, ")


@pytest.mark.parametrize("name", ["", "finder/x.urdf", "/tmp/find/x.urdf", "urdf/find me.urdf"])
def test_other_names_are_not_taken_for_one(name):
    assert torn_find(name) is None


def test_a_path_that_begins_in_a_package(packages):
    assert how_to_name("urdf/robot.urdf", packages).startswith(f"{RIGHT}: a relative path")


def test_the_way_of_meshes(packages):
    assert how_to_name("package://arm/urdf/robot.urdf", packages).startswith(f"{RIGHT}; package://")


def test_a_slip_in_the_name(tmp_path, packages):
    name = str(tmp_path / "arm/urdf/robt.urdf")
    assert how_to_name(name, packages).startswith("Did you mean robot.urdf")


def test_a_file_in_another_folder_of_the_package_is_told_if_it_is_the_only_one(tmp_path, packages):
    assert how_to_name(str(tmp_path / "arm/robot.urdf"), packages) == f"{RIGHT}: there it is."
    assert "best as" in how_to_name(str(tmp_path / "arm/twin.urdf"), packages)
    assert "best as" in how_to_name(str(tmp_path / "elsewhere/robot.urdf"), packages)


def test_of_what_may_not_be_read_not_even_that_it_is_there_is_told(tmp_path, packages):
    def nothing(path):
        return False

    for name in ("urdf/robot.urdf", str(tmp_path / "arm/robot.urdf")):
        assert "robot.urdf" in how_to_name(name, packages)
        assert "robot.urdf" not in how_to_name(name, packages, nothing)
