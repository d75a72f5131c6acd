"""Joints: states, stops, and what drives them."""

from __future__ import annotations

import math

import pytest

from simkit.physics import Mode, PhysicsError

SECOND = 1_000_000_000
INERTIA = 0.05
"Of the lever below about its joint [kg m^2]: 1 kg, 0.2 m away, and 0.01 of its own."


@pytest.fixture
def lever(new_world, plan_text):
    """A lever along x that turns about y; 1.96 N m hold it against gravity."""

    def make(kind="continuous", limit="", gravity=9.8, tags=""):
        world = new_world(gravity=(0.0, 0.0, -gravity), ground=False)
        plan = plan_text(
            f"""<link name="world"/><joint name="j" type="{kind}"><parent link="world"/><child link="a"/>
          <axis xyz="0 1 0"/>{limit}</joint>
          <link name="a"><inertial><mass value="1"/><origin xyz="0.2 0 0"/>
          <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>{tags}"""
        )
        return world, world.add(plan).joint("j")

    return make


LIMIT = '<limit lower="{}" upper="{}" effort="{}" velocity="{}"/>'


@pytest.mark.parametrize(("lower", "upper"), [(-0.5, 0.5), (0.3, 0.6), (-1.0, 0.0)])
def test_a_joint_stops_at_its_limits(lever, lower, upper):
    world, joint = lever("revolute", LIMIT.format(lower, upper, 10, 10))
    assert lower <= joint.position <= upper
    highest = joint.position
    for _ in range(2000):
        world.step()
        highest = max(highest, joint.position)
    assert highest < upper + 0.02
    assert joint.position == pytest.approx(
        upper, abs=1e-3
    )  # gravity turns it down, which is positive
    assert joint.velocity == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("place", [0.0, 0.2])
def test_a_joint_without_room_stands_still(lever, place):
    world, joint = lever("revolute", LIMIT.format(place, place, 10, 10))
    world.run(SECOND)
    assert joint.position == pytest.approx(place, abs=1e-3)
    assert joint.velocity == pytest.approx(0.0, abs=1e-3)


def test_positions_are_not_wrapped(lever):
    world, joint = lever(gravity=0.0)
    joint.command_velocity(20.0)
    world.run(2 * SECOND)
    assert joint.position == pytest.approx(40.0, abs=0.05)


def test_an_effort_drives(lever):
    world, joint = lever(gravity=0.0)
    joint.command_effort(0.5)
    world.run(SECOND)
    assert joint.velocity == pytest.approx(0.5 / INERTIA, rel=1e-6)
    assert joint.effort == 0.5
    assert joint.mode is Mode.EFFORT


def test_an_effort_is_bounded_by_its_limit(lever):
    world, joint = lever("continuous", LIMIT.format(0, 0, 0.2, 100), gravity=0.0)
    joint.command_effort(-5.0)
    world.run(SECOND)
    assert joint.velocity == pytest.approx(-0.2 / INERTIA, rel=1e-6)
    assert joint.is_saturated
    joint.command_effort(0.1)
    world.step()
    assert not joint.is_saturated


def test_no_effort_drives_beyond_the_fastest_speed(lever):
    world, joint = lever("continuous", LIMIT.format(0, 0, 10, 2), gravity=0.0)
    joint.command_effort(1.0)
    world.run(SECOND)
    assert joint.velocity == pytest.approx(2.0, abs=1.0 / INERTIA * 0.001 + 1e-9)
    joint.command_effort(-1.0)
    world.run(10_000_000)
    assert joint.velocity < 1.9


def test_a_joint_may_be_pushed_beyond_the_fastest_speed(lever):
    world, joint = lever("continuous", LIMIT.format(0, 0, 10, 0.0))
    world.run(SECOND // 4)
    assert joint.velocity > 1.0


def test_an_effort_holds_against_gravity(lever):
    world, joint = lever()
    joint.command_effort(-9.8 * 0.2)
    world.run(SECOND // 10)
    assert joint.position == pytest.approx(0.0, abs=1e-9)


def test_a_motor_holds_its_speed(lever):
    world, joint = lever()
    joint.command_velocity(1.5, effort=50.0)
    world.run(SECOND)
    assert joint.velocity == pytest.approx(1.5, abs=1e-9)
    assert joint.position == pytest.approx(1.5, abs=2e-3)
    assert joint.effort == pytest.approx(-9.8 * 0.2 * math.cos(joint.position), abs=5e-3)
    assert not joint.is_saturated


def test_a_weak_motor_gives_all_that_it_has(lever):
    world, joint = lever()
    joint.command_velocity(0.0, effort=1.0)
    world.run(SECOND // 10)
    assert joint.effort == pytest.approx(-1.0)
    assert joint.is_saturated
    assert joint.position == pytest.approx(0.5 * 0.96 / INERTIA * 0.01, rel=0.02)


def test_a_motor_takes_the_effort_of_its_joint_if_none_is_given(lever):
    world, joint = lever("continuous", LIMIT.format(0, 0, 1.0, 10))
    joint.command_velocity(0.0)
    world.run(SECOND // 10)
    assert joint.effort == pytest.approx(-1.0)


def test_a_position_is_followed_exactly(lever):
    world, joint = lever()
    for step in range(1, 1001):
        target = 0.5 * math.sin(0.01 * step)
        joint.command_position(target)
        world.step()
        assert joint.position == target
    world.run(SECOND)
    assert joint.position == target
    assert joint.velocity == 0.0
    assert joint.effort == pytest.approx(-9.8 * 0.2 * math.cos(target), abs=1e-9)


def test_on_its_way_to_a_position_it_has_the_velocity_that_takes_it_there(lever):
    world, joint = lever()
    joint.command_position(0.001)
    world.step()
    joint.command_position(0.003)
    world.step()
    assert joint.velocity == pytest.approx(2.0)


def test_a_long_way_is_jumped_without_velocity(lever):
    world, joint = lever()
    joint.command_position(1.0)
    world.step()
    assert (joint.position, joint.velocity) == (1.0, 0.0)


def test_a_position_stays_within_the_limits(lever):
    world, joint = lever("revolute", LIMIT.format(-0.5, 0.5, 10, 10))
    joint.command_position(2.0)
    world.step()
    assert joint.position == 0.5
    assert joint.command == 0.5


def test_a_joint_that_is_let_go_falls(lever):
    world, joint = lever()
    joint.command_position(0.0)
    world.run(SECOND)
    joint.release()
    world.run(SECOND // 5)
    assert joint.position > 0.3
    assert joint.effort == 0.0


def test_a_held_joint_can_be_put_somewhere(lever):
    world, joint = lever()
    joint.command_position(0.1)
    world.run(SECOND // 10)
    joint.set_position(0.4)
    world.run(SECOND // 10)
    assert joint.position == 0.4


def test_every_kind_of_command_can_follow_every_other(lever):
    world, joint = lever(gravity=0.0)
    commands = [
        lambda: joint.command_effort(0.1),
        lambda: joint.command_velocity(1.0, effort=5.0),
        lambda: joint.command_position(0.3),
        joint.release,
    ]
    for first in commands:
        for then in commands:
            joint.reset()
            first()
            world.run(5_000_000)
            joint.set_velocity(0.0)
            joint.set_position(0.0)
            then()
            world.run(100_000_000)
            outcome = {
                Mode.EFFORT: (joint.velocity, 0.1 / INERTIA * 0.1),
                Mode.VELOCITY: (joint.velocity, 1.0),
                Mode.POSITION: (joint.position, 0.3),
                Mode.FREE: (joint.velocity, 0.0),
            }[joint.mode]
            assert outcome[0] == pytest.approx(outcome[1], abs=1e-9)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_no_number_is_refused(lever, value):
    world, joint = lever()
    for command in (
        joint.command_effort,
        joint.command_velocity,
        joint.command_position,
        joint.set_position,
        joint.set_velocity,
    ):
        with pytest.raises(PhysicsError, match="joint j"):
            command(value)
    world.run(SECOND // 10)
    assert math.isfinite(joint.position)


def test_a_prismatic_joint_slides(new_world, plan_text):
    world = new_world(ground=False)
    plan = plan_text(
        """<link name="world"/><joint name="j" type="prismatic"><parent link="world"/><child link="a"/>
      <axis xyz="0 0 1"/><limit lower="-1" upper="0.5" effort="100" velocity="10"/></joint>
      <link name="a"><inertial><mass value="2"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
    )
    slider = world.add(plan).joint("j")
    slider.command_velocity(0.25)
    world.run(SECOND)
    assert slider.position == pytest.approx(0.25, abs=1e-3)
    assert slider.effort == pytest.approx(2 * 9.8, rel=1e-3)
    slider.release()
    world.run(2 * SECOND)
    assert slider.position == pytest.approx(-1.0, abs=1e-3)
