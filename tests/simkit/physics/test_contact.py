"""Contacts: who touches whom, where, and how hard."""

from __future__ import annotations

import math

import pytest

SECOND = 1_000_000_000


def test_a_box_on_the_ground(new_world, solid, at):
    world = new_world()
    world.add(solid("box", 0.2, 0.3, 0.1, mass=2.0), pose=at(z=0.05))
    world.run(SECOND)
    found = world.contacts()
    assert len(found) == 4
    assert sum(one.force[2] for one in found) == pytest.approx(2 * 9.8, rel=1e-6)
    corners = sorted((round(one.point[0], 3), round(one.point[1], 3)) for one in found)
    assert corners == [(-0.1, -0.15), (-0.1, 0.15), (0.1, -0.15), (0.1, 0.15)]
    for one in found:
        assert (one.first.model, one.first.link, one.first.shape) == (
            "box",
            "body",
            "body_collision",
        )
        assert (one.second.model, one.second.link) == ("ground_plane", "link")
        assert one.normal == pytest.approx((0.0, 0.0, 1.0))
        assert 0.0 <= one.depth < 1e-4


def test_a_contact_names_the_link_of_the_file_and_the_body(new_world, robot_plan, at):
    world = new_world()
    world.add(robot_plan("car"))
    world.run(SECOND)
    ball = next(one.first for one in world.contacts() if one.first.link == "front_wheel")
    assert ball.body == "base_link"
    assert ball.shape == "base_link_fixed_joint_lump__front_wheel_collision"


def test_overlaps_need_no_step(new_world, solid, at):
    world = new_world()
    world.add(solid("sphere", 0.1), pose=at(z=0.07))
    assert world.contacts() == ()
    (one,) = world.overlaps()
    assert one.depth == pytest.approx(0.03)
    assert one.force == (0.0, 0.0, 0.0)
    assert world.time_ns == 0


def test_what_is_apart_does_not_touch(new_world, solid, at):
    world = new_world()
    world.add(solid("sphere", 0.1), pose=at(z=0.2))
    assert world.overlaps() == ()


SPHERE = """<link name="{0}"><inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/>
  </inertial><collision><geometry><sphere radius="0.1"/></geometry></collision></link>"""
CHAIN = "".join(map(SPHERE.format, "abc")) + "".join(
    f'<joint name="{p}{c}" type="continuous"><parent link="{p}"/><child link="{c}"/>'
    '<origin xyz="0.05 0 0"/><axis xyz="0 0 1"/></joint>'
    for p, c in ("ab", "bc")
)


def pairs(world) -> set[frozenset[str]]:
    return {frozenset((one.first.link, one.second.link)) for one in world.overlaps()}


@pytest.mark.parametrize(
    ("collide", "expected"),
    [("", set()), ("a", {"ac"}), ("b", set()), ("c", {"ac"}), ("abc", {"ac"})],
)
def test_links_of_one_model_touch_only_if_one_says_so_and_never_along_a_joint(
    new_world, plan_text, collide, expected
):
    tags = "".join(
        f'<gazebo reference="{link}"><selfCollide>true</selfCollide></gazebo>' for link in collide
    )
    world = new_world(ground=False)
    world.add(plan_text(CHAIN + tags))
    assert pairs(world) == {frozenset(pair) for pair in expected}


def test_a_robot_whose_links_reach_into_each_other_stays_in_one_piece(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(z=0.0))
    assert not {one.first.model for one in world.overlaps()} & {
        one.second.model for one in world.overlaps()
    }
    world.run(SECOND)
    assert math.hypot(*car.twist[0]) < 1e-3


def test_different_models_touch(new_world, solid, at):
    world = new_world()
    world.add(solid("box", 0.2, 0.2, 0.2), name="low", pose=at(z=0.1))
    world.add(solid("box", 0.2, 0.2, 0.2), name="high", pose=at(z=0.301))
    world.run(SECOND)
    between = [
        one for one in world.contacts() if "ground_plane" not in (one.first.model, one.second.model)
    ]
    assert {(one.first.model, one.second.model) for one in between} <= {
        ("low", "high"),
        ("high", "low"),
    }
    up = sum(one.force[2] * (1 if one.first.model == "high" else -1) for one in between)
    assert up == pytest.approx(9.8, rel=1e-3)
