"""World files by name."""

from __future__ import annotations

import pytest

from simkit import SimkitError, Simulation
from simkit.gazebo.worlds import find_world
from simkit.packages import PackagePath

WORLD = """<?xml version="1.0" ?>
<sdf version="1.4"><world name="mine">
  <include><uri>model://ground_plane</uri></include>
  <include><uri>model://sun</uri></include>
  <gravity>0 0 -1.62</gravity>
  <model name="crate"><pose>1 2 0.5 0 0 0</pose><link name="body">
    <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link></model>
</world></sdf>"""


@pytest.fixture
def package(tmp_path):
    """A package with a world."""
    folder = tmp_path / "my_world"
    (folder / "worlds").mkdir(parents=True)
    (folder / "package.xml").write_text("<package/>")
    (folder / "worlds/moon.world").write_text(WORLD)
    return folder


def test_the_empty_world_is_built_in():
    world = find_world("worlds/empty.world", PackagePath([]))
    assert [model.name for model in world.models] == ["ground_plane"]
    assert world.gravity == (0.0, 0.0, -9.8)


def test_a_world_is_found_by_path_and_in_packages(package):
    packages = PackagePath([package.parent])
    for name in (str(package / "worlds/moon.world"), "worlds/moon.world"):
        world = find_world(name, packages)
        assert (world.name, world.gravity[2]) == ("mine", -1.62)


@pytest.mark.parametrize(
    ("name", "advice"),
    [
        ("moon", "moon.world is there: the name needs its ending"),
        ("mon.world", "did you mean moon.world"),
        ("../nowhere/moon.world", "no such folder"),
    ],
)
def test_a_world_that_is_not_there_is_refused_with_the_nearest(package, name, advice):
    with pytest.raises(SimkitError, match="Could not open file") as caught:
        find_world(str(package / "worlds" / name), PackagePath([package]))
    assert advice in str(caught.value)


def test_a_launch_file_brings_a_world_of_ones_own(package):
    with Simulation(screen=None, package_path=[package.parent]) as sim:
        launched = sim.roslaunch(
            "gazebo_ros",
            "empty_world.launch",
            f"world_name:={package}/worlds/moon.world",
            "paused:=true",
        )
        assert launched.failures == []
        assert list(sim.gazebo.spawned) == ["ground_plane", "crate"]
        assert sim.world.gravity[2] == -1.62
        assert sim.gazebo.paused


def test_confined_nothing_outside_of_packages_is_read(package, tmp_path):
    outside = tmp_path / "outside.world"
    outside.write_text(WORLD)
    with pytest.raises(SimkitError, match="Could not open file"):
        find_world(str(outside), PackagePath([package], confined=True))
    assert find_world(str(outside), PackagePath([package])).name == "mine"
