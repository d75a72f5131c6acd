"""SecondOrder steps are taken where something swings, and only there."""

from __future__ import annotations

import pytest

from simkit.physics.second_order import is_balanced
from simkit.urdf.inertia import Body, diagonal_matrix

SECOND = 1_000_000_000


def is_careful(world, name: str) -> bool:
    watch = world._stepper.watches.get(name)
    return watch is not None and watch.second_order.is_on


@pytest.mark.parametrize(
    ("centre", "moments", "expected"),
    [
        ((0.0, 0.5, 0.0), (1.0, 2.0, 1.0), True),
        ((0.01, 0.0, 0.0), (1.0, 2.0, 1.0), False),
        ((0.0, 0.0, 0.0), (1.0, 2.0, 1.1), False),
    ],
)
def test_a_wheel_is_balanced_about_its_axis(centre, moments, expected):
    assert is_balanced(Body(1.0, centre, diagonal_matrix(moments)), (0.0, 1.0, 0.0)) is expected


def test_an_arm_that_swings_is_stepped_carefully(new_world, robot_plan):
    world = new_world()
    world.add(robot_plan("arm"))
    for _ in range(20):
        world.run(SECOND // 10)
        assert is_careful(world, "hello_ros_robot")


def test_a_car_that_drives_is_not(new_world, robot_plan):
    world = new_world()
    car = world.add(robot_plan("car"))
    car.joint("left_wheel_joint").command_velocity(3.0, effort=5.0)
    car.joint("right_wheel_joint").command_velocity(5.0, effort=5.0)
    world.run(SECOND)
    assert not is_careful(world, "practice_car")
    assert car.twist[0][0] > 0.2


def test_an_arm_that_is_led_is_not(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    for step in range(1, 500):
        for joint in arm.joints.values():
            joint.command_position(0.001 * step)
        world.step()
        assert not is_careful(world, "hello_ros_robot")


def test_a_motor_that_holds_a_speed_holds_it_in_careful_steps_too(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    arm.joint("hip").command_velocity(5.0)
    for _ in range(500):
        world.step()
        assert is_careful(world, "hello_ros_robot")
        assert arm.joint("hip").velocity == pytest.approx(5.0, abs=1e-7)
    assert abs(arm.joint("shoulder").velocity) > 0.5
    arm.joint("hip").release()
    world.run(SECOND // 5)
    assert abs(arm.joint("hip").velocity - 5.0) > 0.1


def test_an_arm_that_is_let_go_is(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    for joint in arm.joints.values():
        joint.command_position(0.0)
    world.run(SECOND)
    assert not is_careful(world, "hello_ros_robot")
    for joint in arm.joints.values():
        joint.release()
    world.step()
    assert is_careful(world, "hello_ros_robot")


def test_what_tumbles_and_what_falls_is(new_world, solid, at):
    world = new_world(ground=False)
    box = world.add(solid("box", 0.1, 0.2, 0.3))
    world.run(SECOND)
    assert is_careful(world, "box")
    world.gravity = (0.0, 0.0, 0.0)
    box.set_twist((5.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    world.run(SECOND)
    assert not is_careful(world, "box")
    box.set_twist((0.0, 0.0, 0.0), (4.0, 0.0, 0.0))
    world.run(SECOND)
    assert is_careful(world, "box")


def test_the_ground_never_is(new_world):
    world = new_world()
    assert not is_careful(world, "ground_plane")
