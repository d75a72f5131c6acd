"""Friction and rolling on a slope."""

from __future__ import annotations

import math

import pytest

SECOND = 1_000_000_000
ANGLE = 0.3
SLOPE = (math.cos(ANGLE), 0.0, -math.sin(ANGLE))
"Downhill: the slope is turned about y."


def on_slope(x: float, height: float) -> tuple[float, float, float]:
    """A point at a height above the slope whose upper face goes through the origin."""
    return (x * SLOPE[0] + height * math.sin(ANGLE), 0.0, x * SLOPE[2] + height * math.cos(ANGLE))


@pytest.fixture
def slope_world(new_world, solid, at):
    """A world with a slope of 0.3 rad; friction of the slope is 2."""
    world = new_world(ground=False)
    plan = solid("box", 60.0, 4.0, 1.0, mu=2.0, still=True)
    x, y, z = on_slope(0.0, -0.5)
    world.add(plan, name="slope", pose=at(x, y, z, angle=ANGLE, axis=(0, 1, 0)))
    return world


def downhill(model) -> float:
    """How far it is down the slope [m]."""
    x, _, z = model.pose.translation
    return x * SLOPE[0] + z * SLOPE[2]


@pytest.mark.parametrize("mu", [0.0, 0.1, 0.2, 0.28, 0.34, 0.5, 1.0])
def test_a_box_slides_if_the_slope_is_steeper_than_its_friction(slope_world, solid, at, mu):
    x, y, z = on_slope(0.0, 0.05)
    pose = at(x, y, z, angle=ANGLE, axis=(0, 1, 0))
    box = slope_world.add(solid("box", 0.2, 0.2, 0.1, mu=mu), pose=pose)
    slope_world.run(SECOND)
    expected = 0.5 * 9.8 * max(0.0, math.sin(ANGLE) - mu * math.cos(ANGLE))
    assert downhill(box) == pytest.approx(expected, abs=2e-3)


def test_the_smaller_friction_of_two_counts(new_world, solid, at):
    world = new_world()  # the ground has 100
    box = world.add(solid("box", 0.2, 0.2, 0.1, mu=0.3), pose=at(z=0.05))
    world.run(SECOND // 10)
    box.set_twist((2.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    world.run(SECOND // 10)
    assert box.twist[0][0] == pytest.approx(2.0 - 0.3 * 9.8 * 0.1, rel=1e-3)


@pytest.mark.parametrize(
    ("kind", "sizes", "share"), [("cylinder", (0.1, 0.3), 2 / 3), ("sphere", (0.1,), 5 / 7)]
)
def test_what_rolls_down_is_slower_by_its_inertia(slope_world, solid, at, kind, sizes, share):
    x, y, z = on_slope(0.0, 0.1)
    pose = at(x, y, z, angle=math.pi / 2, axis=(1, 0, 0))
    roller = slope_world.add(solid(kind, *sizes), pose=pose)
    slope_world.run(2 * SECOND)
    expected = share * 0.5 * 9.8 * math.sin(ANGLE) * 2.0**2
    assert downhill(roller) == pytest.approx(expected, rel=0.01)
    linear, angular = roller.twist
    assert math.hypot(*angular) * 0.1 == pytest.approx(math.hypot(*linear), rel=0.01)


def test_a_cylinder_without_friction_slides_and_does_not_turn(slope_world, solid, at):
    x, y, z = on_slope(0.0, 0.1)
    pose = at(x, y, z, angle=math.pi / 2, axis=(1, 0, 0))
    log = slope_world.add(solid("cylinder", 0.1, 0.3, mu=0.0), pose=pose)
    slope_world.run(SECOND)
    assert downhill(log) == pytest.approx(0.5 * 9.8 * math.sin(ANGLE), rel=0.01)
    assert math.hypot(*log.twist[1]) < 1e-3
