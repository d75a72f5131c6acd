"""The engine looks for no contacts that cannot be, and finds all that are."""

from __future__ import annotations

import pytest

from simkit.physics.collision_filter import CollisionFilter

SECOND = 1_000_000_000


def searched(world) -> int:
    """How many shapes the engine looks at."""
    return world._engine.getConstraintSolver().getCollisionGroup().getNumShapeFrames()


def pairs(contacts):
    return {frozenset((one.first.body, one.second.body)) for one in contacts}


def test_an_arm_out_of_reach_of_everything_is_not_searched(new_world, robot_plan):
    world = new_world()
    world.add(robot_plan("arm"))
    world.step()
    assert searched(world) == 0
    # its foot stands on the ground all the same
    assert pairs(world.contacts()) == pairs(world.overlaps()) == {frozenset(("base_link", "link"))}
    assert searched(world) == 0


def test_nothing_else_changes(new_world, robot_plan, at, monkeypatch):
    states = []
    for patched in (False, True):
        if patched:
            monkeypatch.setattr(CollisionFilter, "_idle", lambda self: frozenset())
        world = new_world()
        arm = world.add(robot_plan("arm"), pose=at(x=0.3))
        world.run(SECOND)
        assert searched(world) == (4 if patched else 0)
        states.append(arm.built.skeleton.getPositions().tobytes())
    assert states[0] == states[1]


def test_what_comes_later_is_hit(new_world, robot_plan, solid, at):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    world.run(SECOND // 10)
    world.add(solid("box", 0.2, 0.2, 0.2), name="box", pose=at(x=0.15, z=1.2))
    hit = False
    for _ in range(600):
        world.step()
        hit = hit or any("box" in (c.first.model, c.second.model) for c in world.contacts())
    assert hit
    world.remove("box")
    world.step()
    assert searched(world) == 0
    assert arm.joint("shoulder").position != 0.0


@pytest.mark.parametrize("far", [0.45, 1.5])
def test_a_wall_within_reach_is_searched_and_one_beyond_is_not(
    new_world, robot_plan, solid, at, far
):
    world = new_world(ground=False)
    world.add(robot_plan("arm"))
    world.add(solid("box", 0.1, 2.0, 2.0, still=True), name="wall", pose=at(x=far))
    world.run(SECOND // 2)
    touched = any("wall" in (c.first.model, c.second.model) for c in world.contacts())
    assert (searched(world) > 0) == (far < 1.0)
    assert not touched or far < 1.0


@pytest.mark.parametrize("back", ["put", "reset"])
def test_an_arm_that_is_put_down_can_touch_the_ground(new_world, robot_plan, at, back):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    world.step()
    assert searched(world) == 0
    arm.set_pose(at(z=-0.3))
    arm.joint("shoulder").set_position(1.5)
    world.run(SECOND // 10)
    assert searched(world) == 3  # the torso too is in the ground now, and may touch it
    assert frozenset(("upper_arm", "link")) in pairs(world.contacts())
    if back == "put":
        arm.set_pose(at())
    else:
        world.reset()
    world.step()
    assert searched(world) == 0


def test_moving_joints_from_outside_lets_nobody_look_again_who_can_touch_whom(
    new_world, robot_plan, monkeypatch
):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    world.step()
    monkeypatch.setattr(CollisionFilter, "_idle", lambda self: pytest.fail("looked again"))
    arm.set_joint_positions({"shoulder": 0.5})
    world.step()
    assert searched(world) == 0


def test_a_world_that_was_changed_and_changed_back_goes_on_alike(new_world, robot_plan, solid, at):
    states = []
    for detour in (False, True):
        world = new_world()
        if detour:
            world.add(robot_plan("arm"), name="other", pose=at(x=5.0))
            world.step()
            world.remove("other")
            world.reset()
        car = world.add(robot_plan("car"), pose=at(z=0.2))
        world.add(solid("box", 0.2, 0.2, 0.2), name="box", pose=at(x=0.3, z=1.0))
        world.run(SECOND // 2)
        states.append(car.built.skeleton.getPositions().tobytes())
    assert states[0] == states[1]


def test_what_is_gone_is_not_hit(new_world, robot_plan, solid, at):
    world = new_world()
    world.add(robot_plan("arm"))
    world.run(SECOND // 10)
    for name in ("one", "two"):  # now everything is searched again
        world.add(solid("box", 0.2, 0.2, 0.2), name=name, pose=at(x=2.0, z=0.1))
        world.run(SECOND // 10)
        world.remove(name)
        world.step()
        assert {c.first.model for c in world.contacts()} <= {"hello_ros_robot", "ground_plane"}
        assert searched(world) == 0


def test_asking_what_overlaps_leaves_the_last_contacts_alone(new_world, robot_plan, solid, at):
    world = new_world()
    arm = world.add(robot_plan("arm"), pose=at(z=-0.3))
    arm.joint("shoulder").set_position(1.5)
    world.run(SECOND // 10)
    before = world.contacts()
    assert {"upper_arm", "base_link"} <= {one.first.body for one in before} | {
        one.second.body for one in before
    }
    for _ in range(20):
        assert pairs(world.overlaps()) == pairs(before)
        assert world.contacts() == before
    arm.set_pose(at(z=0.5))
    assert world.contacts() == before  # they are those of the last step
    assert not world.overlaps()
    world.step()
    assert not world.contacts()
    world.run(SECOND // 10)
