from __future__ import annotations

import math

import pytest

from simkit.errors import UnknownNameError
from simkit.viz.stage.parts import Role
from simkit.viz.stage.world_scene import WorldSettings, make_actor
from simkit.viz.stage.world_source import (
    ForceScale,
    WorldSource,
    contact_marks,
    laser_marks,
    scan_points,
)


def source(sim, *, is_live=False, **settings):
    return WorldSource(sim.gazebo, WorldSettings(**settings), is_live=is_live)


def test_a_scene_shows_the_models_as_they_are_now(sim, cart):
    found = source(sim)
    before = found.scene()
    assert before.headline == "cart, after 0.10 s"
    cart.model.set_pose(cart.model.pose._replace(translation=(1.0, 2.0, 0.05)))
    origins = {pose.name: pose.origin for pose in found.scene().tf.poses}
    assert origins["cart::base"] == pytest.approx((1.0, 2.0, 0.05))
    assert {pose.name for pose in before.tf.poses} == set(origins)


def test_a_world_without_models_is_a_ground(sim):
    scene = WorldSource(sim.gazebo, WorldSettings()).scene()
    assert scene.headline == "An empty world, after 0.00 s"
    assert [placed.solid.role for placed in scene.solids] == [Role.GROUND]
    assert scene.tf.poses == ()


def test_shapes_are_others_only_when_models_come_or_go(sim, cart):
    found = source(sim)
    first = found.shapes()
    sim.run(0.1)
    assert found.shapes() == first
    sim.gazebo.delete("cart")
    second = found.shapes()
    assert second > first
    assert found.frames().poses == ()


def test_a_model_that_takes_the_place_of_another_one_is_made_anew(sim, cart, cart_text):
    found = source(sim)
    first = found.shapes()
    sim.gazebo.delete("cart")
    sim.spawn(cart_text.replace("0.4 0.3 0.1", "0.2 0.2 0.2"), name="cart")
    assert found.shapes() > first
    sizes = {
        p.solid.shape.size
        for p in found.scene().solids
        if p.solid.link == "cart::base" and p.solid.role is Role.VISUAL
    }
    assert sizes == {(0.2, 0.2, 0.2)}


def test_contacts_and_scans_are_displays_of_every_scene(sim, cart):
    marks = source(sim, contacts=True).scene().marks
    assert [(one.name, one.is_on) for one in marks] == [("contacts", True), ("scans", True)]
    assert marks[0].points
    assert [one.name for one in source(sim).marks()] == ["contacts", "scans"]


def test_a_model_to_look_at_must_be_there(sim, cart):
    with pytest.raises(UnknownNameError, match="no model 'car'; did you mean 'cart'"):
        source(sim, look_at="car")


def test_a_view_that_follows_leaves_room_to_drive_and_tells_no_time(sim, cart):
    still, live = source(sim).scene(), source(sim, is_live=True).scene()
    assert live.stage.camera.distance > 2 * still.stage.camera.distance
    assert live.headline == "cart"


def test_many_names_are_cut_short(sim, cart):
    for number in range(8):
        sim.world.add(cart.model.plan, name=f"cart{number}")
    assert source(sim).scene().headline == (
        "cart, cart0, cart1, cart2, cart3, cart4 and 3 more, after 0.10 s"
    )


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
