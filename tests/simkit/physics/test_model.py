"""Models: poses, velocities, pushes."""

from __future__ import annotations

import math

import pytest

from simkit.errors import UnknownNameError
from simkit.geometry import Transform
from simkit.physics import PhysicsError
from simkit.urdf import load_robot
from simkit.urdf.kinematics import forward_kinematics

SECOND = 1_000_000_000


def same(one, other, tolerance=1e-9) -> bool:
    sign = math.copysign(1.0, sum(a * b for a, b in zip(one.rotation, other.rotation, strict=True)))
    flipped = tuple(sign * c for c in other.rotation)
    return one.translation == pytest.approx(other.translation, abs=tolerance) and (
        one.rotation == pytest.approx(flipped, abs=tolerance)
    )


def test_links_are_where_forward_kinematics_says(new_world, robot_plan, at):
    from pathlib import Path

    text = (Path(__file__).parent / "robots" / "arm.urdf").read_text()
    pose = at(1.0, 2.0, 0.5, angle=0.7, axis=(1, 2, 3))
    world = new_world()
    arm = world.add(robot_plan("arm"), pose=pose)
    arm.set_joint_positions({"hip": 0.4, "shoulder": -1.1})
    expected = forward_kinematics(load_robot(text, file="arm.urdf"), {"hip": 0.4, "shoulder": -1.1})
    for link in arm.links:
        assert same(arm.link_pose(link), pose @ expected[link])


def test_lumped_links_are_where_they_belong(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(1.0, 0.0, 0.1, angle=math.pi / 2))
    assert car.link_pose("front_wheel").translation == pytest.approx((1.0, 0.2, 0.2))
    assert car.link_pose("left_wheel").translation == pytest.approx((1.0 - 0.225, -0.15, 0.2))


def test_a_pose_that_is_set_is_the_pose(new_world, robot_plan, at):
    world = new_world()
    for name in ("arm", "car"):
        model = world.add(robot_plan(name), name=name)
        pose = at(3.0, -1.0, 2.0, angle=1.0, axis=(0, 1, 1))
        model.set_pose(pose)
        assert same(model.pose, pose)
    assert same(world.model("car").link_pose("base_link"), pose)


def test_a_model_takes_its_floating_parts_along(new_world, plan_text, at):
    mass = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    plan = plan_text(
        f"""<link name="a">{mass}</link><link name="b">{mass}</link>
      <joint name="j" type="floating"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/></joint>"""
    )
    world = new_world(ground=False)
    model = world.add(plan)
    model.set_pose(at(z=5.0, angle=math.pi / 2))
    assert model.link_pose("b").translation == pytest.approx((0.0, 1.0, 5.0))


def test_a_velocity_that_is_set_is_the_velocity(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(z=3.0, angle=1.0, axis=(1, 1, 0)))
    car.set_twist((1.0, 2.0, 3.0), (0.3, 0.2, 0.1))
    linear, angular = car.twist
    assert linear == pytest.approx((1.0, 2.0, 3.0))
    assert angular == pytest.approx((0.3, 0.2, 0.1))


def test_the_velocity_of_a_link_is_that_of_its_origin(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(z=3.0))
    car.set_twist((0.0, 0.0, 0.0), (0.0, 0.0, 2.0))
    car.joint("left_wheel_joint").set_velocity(5.0)
    linear, angular = car.link_twist("left_wheel")
    assert linear == pytest.approx((-2 * 0.225, -2 * 0.15, 0.0))
    assert angular == pytest.approx((0.0, 5.0, 2.0))
    assert car.link_twist("front_wheel")[0] == pytest.approx((0.0, 0.4, 0.0))


def test_a_push_lasts_one_step(new_world, solid, at):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    box = world.add(solid("box", 0.2, 0.2, 0.2, mass=2.0))
    box.push("body", force=(4.0, 0.0, 0.0))
    world.run(SECOND)
    assert box.twist[0][0] == pytest.approx(4.0 / 2.0 * 0.001)
    assert box.twist[1] == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


def test_a_push_beside_the_middle_turns(new_world, solid, at):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    box = world.add(solid("box", 0.2, 0.2, 0.2, mass=2.0), pose=at(angle=math.pi / 2))
    box.push("body", force=(0.0, 6.0, 0.0), torque=(0.0, 0.0, 0.1), point=(0.0, -0.1, 0.0))
    world.step()
    about = 2.0 * (0.2**2 + 0.2**2) / 12
    assert box.twist[1][2] == pytest.approx((0.6 + 0.1) / about * 0.001, rel=1e-6)


def test_a_link_that_was_lumped_can_be_pushed(new_world, robot_plan, at):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    car = world.add(robot_plan("car"))
    for _ in range(100):
        car.push("front_wheel", force=(0.0, 1.0, 0.0))
        world.step()
    assert car.twist[1][2] > 0.01


def test_energy_and_mass(new_world, solid, at):
    world = new_world()
    ball = world.add(solid("sphere", 0.1, mass=3.0), pose=at(z=2.0))
    ball.set_twist((2.0, 0.0, 0.0), (0.0, 5.0, 0.0))
    assert ball.mass == 3.0
    assert ball.centre_of_mass == pytest.approx((0.0, 0.0, 2.0))
    assert ball.potential_energy == pytest.approx(3 * 9.8 * 2)
    assert ball.kinetic_energy == pytest.approx(0.5 * 3 * 4 + 0.5 * 0.4 * 3 * 0.01 * 25)


def test_unknown_names_are_named(new_world, robot_plan):
    world = new_world()
    car = world.add(robot_plan("car"))
    with pytest.raises(UnknownNameError, match="left_wheel_joint"):
        car.joint("left_whel_joint")
    with pytest.raises(UnknownNameError, match="chaiss"):
        car.link_pose("chassis")
    with pytest.raises(UnknownNameError, match="moving joint in 'practice_car'"):
        car.joint("base_joint")


def test_a_model_without_a_body_is_there(new_world, plan_text, at):
    world = new_world()
    empty = world.add(plan_text('<link name="a"/>'), name="empty", pose=at(x=1.0))
    world.run(SECOND // 10)
    assert empty.pose.translation == (1.0, 0.0, 0.0)
    assert (empty.mass, empty.kinetic_energy, empty.potential_energy) == (0.0, 0.0, 0.0)
    assert empty.twist == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert empty.links == ()
    empty.set_pose(at(x=2.0))
    assert empty.centre_of_mass == (2.0, 0.0, 0.0)
    world.reset()
    assert empty.pose.translation == (1.0, 0.0, 0.0)
    world.remove("empty")


@pytest.mark.parametrize(
    "pose", [Transform((math.nan, 0, 0), (0, 0, 0, 1)), Transform((0.0, 0, 0), (0, 0, 0, 0))]
)
def test_a_pose_that_is_none_is_refused(new_world, robot_plan, pose):
    world = new_world()
    with pytest.raises(PhysicsError, match="no pose"):
        world.add(robot_plan("car"), pose=pose)
    car = world.add(robot_plan("car"))
    with pytest.raises(PhysicsError, match="no pose"):
        car.set_pose(pose)
    with pytest.raises(PhysicsError, match="cannot have"):
        car.set_twist((math.inf, 0, 0), (0, 0, 0))
    with pytest.raises(PhysicsError, match="cannot be pushed"):
        car.push("chaiss", force=(0, 0, math.nan))
