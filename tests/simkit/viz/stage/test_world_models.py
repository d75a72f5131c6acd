from __future__ import annotations

import pytest

from simkit.geometry import rotate
from simkit.urdf import Box, Cylinder, Sphere, load_robot
from simkit.urdf.rules.colours import COLOURS, PATTERNS
from simkit.viz.stage.parts import Role
from simkit.viz.stage.world_models import (
    GREY,
    TOUCHED,
    gazebo_color,
    gazebo_materials,
    model_shapes,
)
from simkit.viz.stage.world_source import things_in

THINGS = """<sdf version="1.6"><model name="things"><static>true</static>
  <link name="wall"><pose>0 0 1 0 0 0</pose>
    <visual name="a"><pose>0 0 0.5 0 0 0</pose><geometry><box><size>2 0.1 1</size></box></geometry>
      <material><ambient>0 0 0 1</ambient><diffuse>0.2 0.4 0.6 0.5</diffuse></material></visual>
    <visual name="b"><geometry><sphere><radius>0.2</radius></sphere></geometry>
      <material><script><name>Gazebo/SkyBlue</name></script></material></visual>
    <visual name="c"><geometry><cylinder><radius>0.2</radius><length>1</length></cylinder></geometry></visual>
    <collision name="a"><geometry><box><size>2 0.1 1</size></box></geometry></collision>
  </link>
  <link name="slope">
    <visual name="plane"><geometry><plane><normal>1 0 0</normal><size>1 1</size></plane></geometry>
      <material><script><name>Gazebo/Green</name></script></material></visual>
    <collision name="plane"><geometry><plane><normal>1 0 0</normal><size>1 1</size></plane></geometry></collision>
  </link></model></sdf>"""


def seen(shapes, role=Role.VISUAL):
    return {
        solid.link: (type(solid.shape), solid.color)
        for solid in shapes.solids
        if solid.role is role
    }


def test_a_link_has_its_gazebo_material_else_its_urdf_colour_else_it_is_grey(cart):
    assert seen(model_shapes(cart, name="cart")) == {
        "cart::base": (Box, (0.2, 0.9, 0.6)),
        "cart::mast": (Cylinder, gazebo_color("Orange")[0]),
        "cart::lid": (Sphere, GREY),
    }


def test_a_link_that_is_not_simulated_is_not_seen(cart):
    assert "flag" in cart.robot.links
    assert "flag" not in cart.model.links
    assert all("flag" not in solid.link for solid in model_shapes(cart, name="cart").solids)


def test_what_others_touch_is_orange(cart):
    assert seen(model_shapes(cart, name="x"), Role.COLLISION) == {"x::base": (Box, TOUCHED)}


def test_of_two_blocks_with_a_material_the_last_one_counts(cart_text):
    more = '<gazebo reference="mast"><material value="Gazebo/Blue"/></gazebo></robot>'
    robot = load_robot(cart_text.replace("</robot>", more), file="cart.urdf")
    assert gazebo_materials(robot) == {"mast": "Gazebo/Blue"}


def test_sdf_has_its_own_colours_and_poses(sim):
    spawned = sim.spawn(THINGS, name="things")
    shapes = model_shapes(spawned, name="things")
    found = {type(one.shape): one for one in shapes.solids if one.role is Role.VISUAL}
    assert (found[Box].color, found[Box].alpha) == ((0.2, 0.4, 0.6), 0.5)
    assert found[Box].translation == (0.0, 0.0, 0.5)
    assert found[Sphere].color == gazebo_color("SkyBlue")[0]
    assert found[Cylinder].color == GREY
    assert [type(s.shape) for s in shapes.solids if s.role is Role.COLLISION] == [Box]


def test_a_plane_is_a_ground_that_knows_where_its_normal_points(sim):
    (ground,) = model_shapes(sim.spawn(THINGS, name="things"), name="things").grounds
    assert (ground.link, ground.color) == ("slope", gazebo_color("Green")[0])
    assert rotate(ground.rotation, (0.0, 0.0, 1.0)) == pytest.approx((1.0, 0.0, 0.0))


def test_a_model_without_a_file_is_drawn_as_what_others_touch(sim, cart):
    plan = cart.model.plan
    sim.world.add(plan, name="twin", pose=cart.model.pose)
    twin = next(one for one in things_in(sim.gazebo) if one.model.name == "twin")
    assert seen(model_shapes(twin, name="twin")) == {"twin::base": (Box, GREY)}


@pytest.mark.parametrize("name", COLOURS)
def test_each_material_that_is_one_colour_has_that_colour(name):
    color, alpha = gazebo_color(f"Gazebo/{name}")
    assert color == (GREY if name in ("Grey", "Gray") else COLOURS[name])
    assert alpha == 1.0


def test_what_is_transparent_or_glows_has_the_colour_of_its_name():
    assert gazebo_color("Gazebo/RedTransparent") == (COLOURS["Red"], 0.5)
    assert gazebo_color("Gazebo/RedTransparentOverlay") == (COLOURS["Red"], 0.5)
    assert gazebo_color("Gazebo/TurquoiseGlowOutline") == (COLOURS["Turquoise"], 1.0)
    assert gazebo_color("Gazebo/BlueLaser") == (COLOURS["Blue"], 1.0)


def test_spaces_and_the_prefix_do_not_matter():
    assert gazebo_color(" Gazebo/Orange\n") == gazebo_color("Orange") == (COLOURS["Orange"], 1.0)


@pytest.mark.parametrize("name", ["", "Gazebo/", "Gazebo/Beige", "Transparent", "Glow"])
def test_an_unknown_material_has_no_colour(name):
    assert gazebo_color(name) is None


def test_every_name_that_the_rules_know_is_taken_without_an_error():
    colors = {name: gazebo_color(f"Gazebo/{name}") for name in PATTERNS}
    assert colors["DarkGray"] == (COLOURS["DarkGrey"], 1.0)
    assert colors["Chrome"] is None
