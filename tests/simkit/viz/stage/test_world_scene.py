from __future__ import annotations

import math
from dataclasses import replace

import pytest

from simkit.geometry import rotate
from simkit.viz.stage.parts import Role, corners
from simkit.viz.stage.world_scene import (
    GAZEBO,
    WORLD,
    WorldSettings,
    ground_solid,
    link_poses,
    make_actor,
    shape_corners,
    world_scene,
)

SLOPE = """<sdf version="1.6"><model name="slope"><static>true</static><link name="l"><pose>0 0 1 0 0 0</pose>
  <visual name="v"><geometry><plane><normal>0 -0.6 0.8</normal><size>1 1</size></plane></geometry></visual>
  <collision name="c"><geometry><plane><normal>0 -0.6 0.8</normal><size>1 1</size></plane></geometry></collision>
  </link></model></sdf>"""


def scene_of(gazebo, **settings):
    actors = [make_actor(one, name=name) for name, one in gazebo.spawned.items()]
    frames = [
        pose for one in actors if not one.is_ground for pose in link_poses(one.model, name=one.name)
    ]
    poses = {pose.name: pose for pose in frames}
    return world_scene(
        actors,
        frames,
        WorldSettings(**settings),
        outlines={one.name: list(shape_corners(one.shapes, poses)) for one in actors},
        marks=(),
        headline="here",
    )


def test_links_are_where_physics_says_each_below_the_one_that_it_hangs_on(cart):
    poses = {pose.name: pose for pose in link_poses(cart.model, name="cart")}
    assert {name: pose.parent for name, pose in poses.items()} == {
        "cart::base": WORLD,
        "cart::mast": "cart::base",
        "cart::lid": "cart::base",
    }
    for link in ("base", "mast", "lid"):
        assert poses[f"cart::{link}"].origin == cart.model.link_pose(link).translation
    assert poses["cart::mast"].origin[2] == pytest.approx(0.2, abs=1e-3)


def test_a_scene_has_the_shapes_of_all_models_and_a_ground(sim, cart):
    scene = scene_of(sim.gazebo)
    assert {placed.solid.link for placed in scene.solids} >= {
        "cart::base",
        "cart::mast",
        "cart::lid",
    }
    assert sum(placed.solid.role is Role.GROUND for placed in scene.solids) == 1
    assert (scene.window, scene.headline, scene.tf.fixed_frame) == (GAZEBO, "here", WORLD)


def test_the_ground_is_level_and_just_below_the_grid_under_all_of_it(sim, cart):
    scene = scene_of(sim.gazebo)
    (ground,) = [placed for placed in scene.solids if placed.solid.role is Role.GROUND]
    xs, ys, zs = zip(*corners(ground.solid, None), strict=True)
    assert -0.01 < max(zs) < 0.0
    lines = [scene.stage.cell * line for line in (*scene.stage.grid_x, *scene.stage.grid_y)]
    assert [min(xs), max(xs), min(ys), max(ys)] == pytest.approx(lines)


def test_a_slope_is_a_piece_of_its_plane(sim, cart):
    slope = sim.spawn(SLOPE, name="slope")
    actor = make_actor(slope, name="slope")
    solid = ground_solid(actor.shapes.grounds[0], slope.model, scene_of(sim.gazebo).stage)
    normal = rotate(solid.rotation, (0.0, 0.0, 1.0))
    assert normal == pytest.approx((0.0, -0.6, 0.8))
    x, y, z = solid.translation
    assert math.fsum(n * c for n, c in zip(normal, (x, y, z - 1.0), strict=True)) == pytest.approx(
        0.0, abs=0.02
    )


def test_the_camera_looks_at_one_model_if_asked(sim, cart):
    sim.world.add(
        cart.model.plan, name="far", pose=cart.model.pose._replace(translation=(9.0, 0.0, 0.1))
    )
    everything, near = scene_of(sim.gazebo), scene_of(sim.gazebo, look_at="cart")
    assert near.stage.camera.distance < everything.stage.camera.distance
    assert near.stage.camera.target == pytest.approx((0.0, 0.0, 0.1), abs=0.3)
    assert replace(near.stage, camera=everything.stage.camera) == everything.stage


def test_an_actor_knows_its_size(cart):
    actor = make_actor(cart, name="cart")
    assert not actor.is_ground
    # From the floor to the top of the mast, and from end to end with the lid.
    assert actor.size == pytest.approx(math.dist((-0.2, -0.15, -0.05), (0.25, 0.15, 0.25)), rel=0.1)


def test_too_many_shapes_are_not_drawn(sim, cart, monkeypatch):
    monkeypatch.setattr("simkit.viz.stage.world_scene._MOST_SOLIDS", 3)
    scene = scene_of(sim.gazebo)
    assert len(scene.solids) == 4  # the ground is one more
    assert any(note.startswith("Only the first 3 of ") for note in scene.notes)


def test_at_first_one_sees_the_models_on_the_ground():
    displays = WorldSettings().displays
    assert [role for role in Role if displays.shows(role)] == [Role.VISUAL, Role.GROUND]
    assert (displays.grid, displays.tf, displays.transparent) == (True, False, False)


@pytest.mark.parametrize(
    ("name", "role"),
    [
        ("collisions", Role.COLLISION),
        ("center_of_mass", Role.CENTRE),
        ("inertias", Role.INERTIA),
        ("joints", Role.JOINT),
    ],
)
def test_each_display_of_the_menu_shows_its_shapes(name, role):
    assert WorldSettings(**{name: True}).displays.shows(role)


@pytest.mark.parametrize("name", ["center_of_mass", "inertias", "joints"])
def test_one_sees_through_models_when_something_inside_is_shown(name):
    assert WorldSettings(**{name: True}).displays.transparent is True
    assert WorldSettings(**{name: True}, transparent=False).displays.transparent is False


def test_models_can_be_left_out():
    assert not WorldSettings(models=False).displays.shows(Role.VISUAL)
