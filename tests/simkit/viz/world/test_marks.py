from __future__ import annotations

import math

import pytest

from simkit.viz.world.marks import ForceScale, contact_marks, laser_marks, scan_points
from simkit.viz.world.scene import make_actor

CUBE = """<robot name="cube"><link name="cube">
  <inertial><mass value="2"/><inertia ixx="0.02" iyy="0.02" izz="0.02" ixy="0" ixz="0" iyz="0"/></inertial>
  <visual><geometry><box size="0.3 0.3 0.3"/></geometry></visual>
  <collision><geometry><box size="0.3 0.3 0.3"/></geometry></collision>
</link></robot>"""


@pytest.fixture
def cube(sim):
    """A cube at rest on the ground."""
    spawned = sim.spawn(CUBE, name="cube", xyz=(0.0, 0.0, 0.15))
    sim.run(0.5)
    return spawned


@pytest.fixture
def scale(sim, cube):
    actors = [make_actor(one, name=name) for name, one in sim.gazebo.spawned.items()]
    return ForceScale(actors, sim.world.gravity)


def test_arrows_point_from_the_ground_up_and_carry_the_weight(sim, scale):
    marks = contact_marks(sim.world.contacts(), scale, is_on=True)
    assert len(marks.points) >= 3
    assert all(z == pytest.approx(0.0, abs=1e-3) for _, _, z in marks.points)
    shafts = [line for line in marks.lines if line[0] in marks.points]
    total = sum(tip[2] - start[2] for start, tip in shafts)
    # The weight of the heaviest model is as long as that model is large.
    assert total == pytest.approx(0.3 * math.sqrt(3), rel=0.02)


def test_an_arrow_has_a_head_of_four_barbs_at_its_tip(scale):
    shaft, *barbs = scale.arrow((1.0, 0.0, 0.0), (0.0, 0.0, 10.0))
    assert shaft[0] == (1.0, 0.0, 0.0)
    assert len(barbs) == 4
    assert {barb[0] for barb in barbs} == {shaft[1]}
    assert all(0.0 < barb[1][2] < shaft[1][2] for barb in barbs)


def test_a_tiny_force_has_no_arrow_and_a_huge_one_a_bounded_one(scale):
    assert list(scale.arrow((0.0, 0.0, 0.0), (1e-9, 0.0, 0.0))) == []
    shaft, *_ = scale.arrow((0.0, 0.0, 0.0), (1e9, 0.0, 0.0))
    assert shaft[1][0] == pytest.approx(1.5 * 0.3 * math.sqrt(3))


def test_without_models_there_is_still_a_scale():
    shaft, *_ = ForceScale([], (0.0, 0.0, 0.0)).arrow((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    assert shaft[1] == (1.0, 0.0, 0.0)


def test_the_points_of_lasers_are_those_that_hit_something(sim, m2wr):
    assert m2wr.plugins
    assert scan_points(sim.gazebo.spawned.values()) == ()
    sim.spawn(CUBE, name="cube", xyz=(1.0, 0.0, 0.15))
    sim.run(0.01)
    points = scan_points(sim.gazebo.spawned.values())
    assert len(points) > 20
    assert all(x == pytest.approx(0.85, abs=0.01) for x, _, _ in points)
    assert laser_marks(points, is_on=False).points == points
