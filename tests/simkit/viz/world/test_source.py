from __future__ import annotations

import pytest

from simkit.errors import UnknownNameError
from simkit.viz.solid import Role
from simkit.viz.world.settings import WorldSettings
from simkit.viz.world.source import WorldSource


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
