from __future__ import annotations

import pytest

from simkit.geometry import rotate
from simkit.urdf import Box, Cylinder, Sphere, load_robot
from simkit.viz.solid import Role
from simkit.viz.world.colors import GREY, gazebo_color
from simkit.viz.world.shapes import TOUCHED, gazebo_materials, model_shapes
from simkit.viz.world.source import things_in

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
