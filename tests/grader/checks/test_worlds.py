"""Worlds and robots of students, measured in physics."""

import math

import pytest

from grader.checks.worlds import (
    Place,
    inertia_of,
    loads,
    place_of,
    point_of,
    solid_of,
    spawned_robot,
    started_world,
)
from grader.errors import CheckFailed
from simkit import Simulation
from simkit.urdf import load_robot

UPRIGHT = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
TURNED = ((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0))
"A quarter turn about z."

# A box on which a cylinder lies along y, held by a fixed joint; Gazebo makes one body of the two.
CART = """<robot name="cart">
  <link name="box">
    <inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.25"/></inertial>
    <collision><geometry><box size="0.4 0.2 0.1"/></geometry></collision>
  </link>
  <link name="roll">
    <inertial>
      <origin rpy="1.5707963 0 0"/>
      <mass value="1"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.01"/>
    </inertial>
    <visual><geometry><mesh filename="roll.stl"/></geometry></visual>
    <collision><origin xyz="0 0.1 0" rpy="1.5707963 0 0"/><geometry><cylinder radius="0.05" length="0.3"/></geometry></collision>
    <collision><origin xyz="0.5 0 0"/><geometry><sphere radius="0.02"/></geometry></collision>
  </link>
  <link name="flag"/>
  <joint name="glue" type="fixed"><parent link="box"/><child link="roll"/><origin xyz="0 0 0.1"/></joint>
  <joint name="pole" type="continuous"><parent link="box"/><child link="flag"/></joint>
</robot>"""


@pytest.fixture
def sim():
    with Simulation(screen=None) as simulation:
        yield simulation


@pytest.fixture
def robot():
    return load_robot(CART, file="cart.urdf")


def test_a_link_that_gazebo_melts_away_still_has_its_place(sim):
    model = spawned_robot(
        sim, CART, name="cart", xyz=(1.0, 2.0, 3.0), rpy=(0.0, 0.0, math.pi / 2)
    ).model
    place = place_of(model, "roll")
    assert place.origin == pytest.approx((1.0, 2.0, 3.1))
    assert point_of(place, (0.5, 0.0, 0.0)) == pytest.approx((1.0, 2.5, 3.1))


def test_a_link_without_mass_has_no_place(sim):
    model = spawned_robot(sim, CART, name="cart").model
    with pytest.raises(CheckFailed, match="the link flag is not in the world") as failure:
        place_of(model, "flag")
    assert failure.value.actual == "links in the world: box, roll"


def test_a_robot_without_any_mass_is_empty(sim):
    with pytest.raises(CheckFailed, match="cart is empty in the world"):
        spawned_robot(sim, '<robot name="cart"><link name="a"/></robot>', name="cart")


def test_shapes_take_room_along_the_axes_of_the_world(robot):
    place = Place((1.0, 0.0, 0.0), TURNED)
    (box,) = robot.links["box"].collisions
    roll, ball = robot.links["roll"].collisions
    (mesh,) = robot.links["roll"].visuals
    found = [solid_of(shape, place) for shape in (box, roll, ball, mesh)]
    assert [one.kind for one in found] == ["box", "cylinder", "sphere", "mesh"]
    assert [one.size for one in found] == [
        pytest.approx((0.2, 0.4, 0.1)),
        pytest.approx((0.3, 0.1, 0.1), abs=1e-6),
        pytest.approx((0.04, 0.04, 0.04)),
        (0.0, 0.0, 0.0),
    ]
    assert [one.centre for one in found] == [
        pytest.approx((1.0, 0.0, 0.0)),
        pytest.approx((0.9, 0.0, 0.0)),
        pytest.approx((1.0, 0.5, 0.0)),
        pytest.approx((1.0, 0.0, 0.0)),
    ]


def test_an_inertia_is_seen_in_the_axes_of_the_world(robot):
    for place, right in (
        (Place((0.0, 0.0, 0.0), UPRIGHT), (0.02, 0.01, 0.02)),
        (Place((0.0, 0.0, 0.0), TURNED), (0.01, 0.02, 0.02)),
    ):
        found = inertia_of(robot.links["roll"], place)
        assert [found[i][i] for i in range(3)] == pytest.approx(right)
        assert [found[0][1], found[0][2], found[1][2]] == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_a_link_without_inertia_has_none(robot):
    assert (
        inertia_of(robot.links["flag"], Place((0.0, 0.0, 0.0), UPRIGHT)) == ((0.0, 0.0, 0.0),) * 3
    )


def test_what_stands_is_held_up_by_its_weight(sim):
    spawned_robot(sim, CART, name="cart", xyz=(0.0, 0.0, 0.05))
    assert loads(sim.gazebo, "cart") == {}
    sim.run(0.5)
    assert loads(sim.gazebo, "cart") == {"box": pytest.approx(3 * 9.8, rel=1e-3)}
    assert loads(sim.gazebo, "nobody") == {}


def test_a_launch_file_without_a_world_is_told_so(sim):
    with pytest.raises(CheckFailed, match=r"a\.launch starts no world"):
        started_world(sim, lambda file: None, "a.launch")


def test_the_time_of_a_started_world_passes(sim):
    def launch(file):
        sim.rosrun("gazebo_ros", "gzserver", "-u", "__name:=gazebo")

    gazebo = started_world(sim, launch, "a.launch")
    sim.run(0.1)
    assert gazebo.world.time_ns == 100_000_000
