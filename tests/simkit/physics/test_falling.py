"""Things fall, land without a bounce, and stay where they are."""

from __future__ import annotations

import itertools
import math

import pytest

SECOND = 1_000_000_000


def test_a_fall_of_one_metre_takes_452_ms(new_world, solid, at):
    world = new_world()
    ball = world.add(solid("sphere", 0.1), pose=at(z=1.1))
    while not world.contacts():
        world.step()
    assert world.time_ns == pytest.approx(math.sqrt(2 * 1.0 / 9.8) * 1e9, abs=2e6)
    assert ball.twist[0][2] == pytest.approx(0.0, abs=0.01)


def test_a_fall_follows_the_parabola(new_world, solid, at):
    world = new_world()
    box = world.add(solid("box", 0.1, 0.1, 0.1), pose=at(z=10.0))
    for _ in range(10):
        world.run(SECOND // 10)
        t = world.time_ns / SECOND
        assert box.pose.translation[2] == pytest.approx(10.0 - 9.8 * t * t / 2, abs=1e-9)
        assert box.twist[0][2] == pytest.approx(-9.8 * t, abs=1e-9)


@pytest.mark.parametrize(
    ("kind", "sizes", "height"),
    [("box", (0.2, 0.3, 0.1), 0.05), ("sphere", (0.1,), 0.1), ("cylinder", (0.1, 0.3), 0.15)],
)
def test_what_lands_does_not_bounce_and_stays(new_world, solid, at, kind, sizes, height):
    world = new_world()
    thing = world.add(solid(kind, *sizes), pose=at(z=1.0, angle=0.3))
    while not world.contacts():
        world.step()
    highest = 0.0
    for _ in range(300):
        world.step()
        highest = max(highest, thing.pose.translation[2])
    assert highest <= height + 1e-6
    world.run(SECOND)
    before = thing.pose
    world.run(10 * SECOND)
    assert math.dist(thing.pose.translation, before.translation) < 1e-5
    assert thing.pose.translation[2] == pytest.approx(height, abs=1e-5)


def test_a_cylinder_lies_still_even_when_it_lies_askew(new_world, solid, at):
    world = new_world()
    log = world.add(solid("cylinder", 0.1, 0.3), pose=at(z=0.2, angle=1.57, axis=(1, 0.3, 0)))
    world.run(2 * SECOND)
    before = log.pose
    world.run(10 * SECOND)
    assert math.dist(log.pose.translation, before.translation) < 1e-4
    assert log.pose.translation[2] == pytest.approx(0.1, abs=1e-4)


def test_a_tower_stands(new_world, solid, at):
    world = new_world()
    plan = solid("box", 0.2, 0.2, 0.2)
    boxes = [world.add(plan, name=f"box{i}", pose=at(z=0.1 + 0.21 * i)) for i in range(4)]
    world.run(4 * SECOND)
    for number, box in enumerate(boxes):
        x, y, z = box.pose.translation
        assert math.hypot(x, y) < 1e-3
        assert z == pytest.approx(0.1 + 0.2 * number, abs=1e-4)


def test_the_car_settles_and_does_not_drift(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(z=1.0))
    world.run(2 * SECOND)
    before = car.pose
    world.run(10 * SECOND)
    assert math.dist(car.pose.translation, before.translation) < 1e-3
    assert {(one.first.link, one.second.model) for one in world.contacts()} == {
        ("front_wheel", "ground_plane"),
        ("left_wheel", "ground_plane"),
        ("right_wheel", "ground_plane"),
    }


def test_the_weight_of_the_car_is_shared_as_its_masses_say(new_world, robot_plan, at):
    world = new_world()
    world.add(robot_plan("car"), pose=at(z=0.01))
    world.run(2 * SECOND)
    weights = {}
    for one in world.contacts():
        weights[one.first.link] = weights.get(one.first.link, 0.0) + one.force[2]
    total = sum(weights.values())
    assert total == pytest.approx(2.5 * 9.8, rel=1e-3)
    assert weights["front_wheel"] / total == pytest.approx(0.371, abs=2e-3)


def test_what_is_put_into_the_ground_comes_out_at_rest(new_world, robot_plan):
    world = new_world()
    robot = world.add(robot_plan("m2wr"))
    lowest = min(-one.depth for one in world.overlaps())
    assert lowest == pytest.approx(-0.1, abs=1e-3)
    heights = []
    for _ in range(500):
        world.step()
        heights.append(robot.pose.translation[2])
    assert max(heights) < 0.105
    assert max(b - a for a, b in itertools.pairwise(heights)) < 0.03
    assert robot.pose.translation[2] == pytest.approx(0.1, abs=2e-3)


def test_what_is_stuck_between_walls_stays_there_without_harm(new_world, solid, at):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    wall = solid("box", 0.1, 2.0, 2.0, still=True)
    world.add(wall, name="left", pose=at(x=-0.2))
    world.add(wall, name="right", pose=at(x=0.2))
    ball = world.add(solid("sphere", 0.3))
    world.run(SECOND)
    assert math.hypot(*ball.pose.translation) < 0.5
    assert math.hypot(*ball.twist[0]) < 0.1
