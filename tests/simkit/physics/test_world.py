"""Worlds: the clock, models that come and go, the same numbers every time."""

from __future__ import annotations

import math
import struct
import subprocess
import sys

import pytest

from simkit.errors import UnknownNameError
from simkit.physics import ModelError, PhysicsError, World

SECOND = 1_000_000_000
MS = 1_000_000


def state(world: World) -> bytes:
    """All that can be known of what moves, to the last bit."""
    numbers: list[float] = []
    for model in world.models.values():
        for link in model.links:
            pose, twist = model.link_pose(link), model.link_twist(link)
            numbers += [*pose.translation, *pose.rotation, *twist[0], *twist[1]]
        for joint in model.joints.values():
            numbers += [joint.position, joint.velocity, joint.effort]
    for contact in world.contacts():
        numbers += [*contact.point, *contact.normal, *contact.force, contact.depth]
    return struct.pack(f"{len(numbers)}d", *numbers)


def crowd(world: World, robot_plan, solid, at) -> None:
    """A car that drives into a heap, and an arm that whirls."""
    car = world.add(robot_plan("car"), name="car", pose=at(z=0.3))
    car.joint("left_wheel_joint").command_velocity(3.0, effort=5.0)
    car.joint("right_wheel_joint").command_velocity(4.0, effort=5.0)
    world.add(robot_plan("arm"), name="arm", pose=at(y=-2.0))
    plans = [solid("box", 0.2, 0.2, 0.2), solid("cylinder", 0.1, 0.2), solid("sphere", 0.1)]
    for i in range(5):
        pose = at(0.6 + 0.1 * (i % 2), 0.02 * i, 0.2 + 0.25 * i, angle=0.3 * i, axis=(1, 0, 1))
        world.add(plans[i % 3], name=f"thing{i}", pose=pose)


def test_the_clock_counts_steps(new_world):
    world = new_world()
    world.step()
    assert world.time_ns == MS
    world.run(3 * SECOND)
    assert world.time_ns == 3 * SECOND + MS


def test_time_runs_to_the_last_step_that_fits(new_world):
    world = new_world()
    world.run_until(2_700_000)
    assert world.time_ns == 2 * MS
    world.run_until(1)
    assert world.time_ns == 2 * MS


@pytest.mark.parametrize("duration", [-MS, 1, 1_500_000])
def test_half_a_step_is_refused(new_world, duration):
    with pytest.raises(PhysicsError, match="whole number of steps"):
        new_world().run(duration)


@pytest.mark.parametrize("options", [{"step_ns": 0}, {"gravity": (0.0, 0.0, math.nan)}])
def test_a_world_that_cannot_be_is_refused(new_world, options):
    with pytest.raises(PhysicsError, match="no world"):
        new_world(**options)


def test_other_steps_and_another_gravity(new_world, solid, at):
    world = new_world(step_ns=500_000, gravity=(0.0, 0.0, -1.6))
    ball = world.add(solid("sphere", 0.1), pose=at(z=5.0))
    world.run(SECOND)
    assert ball.pose.translation[2] == pytest.approx(5.0 - 0.8, abs=1e-3)
    world.gravity = (0.0, 0.0, 0.0)
    assert world.gravity == (0.0, 0.0, 0.0)
    speed = ball.twist[0]
    world.run(SECOND)
    assert ball.twist[0] == pytest.approx(speed)
    with pytest.raises(PhysicsError, match="gravity"):
        world.gravity = (math.inf, 0.0, 0.0)


def test_two_worlds_are_equal_to_the_last_bit(new_world, robot_plan, solid, at):
    states = []
    for _ in range(2):
        world = new_world()
        crowd(world, robot_plan, solid, at)
        world.run(SECOND)
        states.append(state(world))
    assert states[0] == states[1]


def test_a_reset_world_is_like_a_new_one(new_world, robot_plan, solid, at):
    world = new_world()
    crowd(world, robot_plan, solid, at)
    car = world.model("car")

    def drive() -> bytes:
        car.joint("left_wheel_joint").command_velocity(3.0, effort=5.0)
        car.joint("right_wheel_joint").command_velocity(4.0, effort=5.0)
        world.run(SECOND)
        return state(world)

    first = drive()
    world.reset()
    assert world.time_ns == 0
    assert world.contacts() == ()
    assert drive() == first


def test_it_does_not_matter_how_the_steps_are_asked_for(new_world, robot_plan, solid, at):
    states = []
    for pieces in ([800], [1] * 800, [7, 32, 761]):
        world = new_world()
        crowd(world, robot_plan, solid, at)
        for piece in pieces:
            world.run(piece * MS)
        states.append(state(world))
    assert states[0] == states[1] == states[2]


def test_hooks_change_nothing_by_being_there(new_world, robot_plan, solid, at):
    states = []
    for hooks in (0, 2):
        world = new_world()
        for _ in range(hooks):
            world.before_step.append(lambda: None)
            world.after_step.append(lambda: None)
        crowd(world, robot_plan, solid, at)
        world.run(SECOND // 2)
        states.append(state(world))
    assert states[0] == states[1]


def test_another_process_finds_the_same_bits(new_world, robot_plan, at):
    program = """
import hashlib, struct
from pathlib import Path
from simkit.geometry import Transform
from simkit.physics import World, plan_robot
from simkit.urdf import load_robot
world = World()
for name in ("car", "m2wr", "arm"):
    text = (Path({folder!r}) / f"{{name}}.urdf").read_text()
    world.add(plan_robot(load_robot(text, file=name)), name=name, pose=Transform((0.1, 0, 0.5), (0, 0, 0, 1)))
world.run(800_000_000)
numbers = [x for m in world.models.values() for l in m.links for x in (*m.link_pose(l)[0], *m.link_pose(l)[1])]
print(hashlib.sha256(struct.pack(f"{{len(numbers)}}d", *numbers)).hexdigest())
"""
    new_world()
    from pathlib import Path

    folder = str(Path(__file__).parent / "robots")
    command = [sys.executable, "-c", program.format(folder=folder)]
    found = {
        subprocess.run(
            command, capture_output=True, text=True, check=True, env={"PYTHONHASHSEED": seed}
        ).stdout
        for seed in ("1", "2")
    }
    assert len(found) == 1


def test_models_come_and_go_while_it_runs(new_world, robot_plan, solid, at):
    world = new_world()
    crowd(world, robot_plan, solid, at)
    world.run(SECOND // 2)
    world.remove("thing0")
    world.remove("arm")
    assert world.contacts() == ()
    world.run(SECOND // 10)
    assert {side.model for one in world.contacts() for side in (one.first, one.second)} <= set(
        world.models
    )
    world.add(robot_plan("arm"), name="arm", pose=at(y=3.0))
    world.run(SECOND)
    assert abs(world.model("arm").joint("shoulder").position) > 0.1


def test_hooks_may_add_and_remove_models(new_world, solid, at):
    world = new_world()
    plan = solid("sphere", 0.1)

    def hook() -> None:
        name = f"ball{world.time_ns // MS}"
        world.add(plan, name=name, pose=at(x=len(world.models), z=0.1))
        if len(world.models) > 4:
            world.remove(next(name for name in world.models if name != "ground_plane"))

    world.after_step.append(hook)
    world.run(50 * MS)
    assert len(world.models) == 4


def test_what_was_removed_can_be_asked_no_harm_done(new_world, robot_plan):
    world = new_world()
    car = world.add(robot_plan("car"))
    joint = car.joint("left_wheel_joint")
    joint.command_position(1.0)
    world.remove("practice_car")
    joint.command_position(2.0)
    world.run(SECOND // 10)
    assert math.isfinite(car.pose.translation[0])
    world.add(robot_plan("car"))
    world.run(SECOND // 10)


def test_a_name_is_taken_once(new_world, robot_plan):
    world = new_world()
    world.add(robot_plan("car"))
    with pytest.raises(ModelError, match="practice_car is already there"):
        world.add(robot_plan("car"))
    with pytest.raises(UnknownNameError, match="practice_car"):
        world.model("practise_car")
    with pytest.raises(UnknownNameError, match="no model 'nobody'"):
        world.remove("nobody")


def test_hooks_are_called_around_each_step_in_order(new_world):
    world = new_world()
    calls: list[tuple[str, int]] = []
    world.before_step.append(lambda: calls.append(("a", world.time_ns)))
    world.before_step.append(lambda: calls.append(("b", world.time_ns)))
    world.after_step.append(lambda: calls.append(("c", world.time_ns)))
    world.run(2 * MS)
    assert calls == [("a", 0), ("b", 0), ("c", MS), ("a", MS), ("b", MS), ("c", 2 * MS)]


def test_a_hook_that_names_its_time_is_called_then_and_in_order(new_world, robot_plan):
    world = new_world()
    world.add(robot_plan("car"))
    calls: list[tuple[str, int]] = []

    def every(name, period_ns):
        def hook() -> None:
            calls.append((name, world.time_ns))

        last = [world.time_ns]
        hooks = world.before_step if name == "before" else world.after_step

        def due() -> int:
            while last[0] + period_ns < world.time_ns or calls[-1:] == [
                (name, last[0] + period_ns)
            ]:
                last[0] += period_ns
            return last[0] + period_ns

        hooks.append(hook)
        world.due[hook] = due

    every("before", 70 * MS)
    every("a", 35 * MS)
    every("b", 35 * MS)
    world.run(100 * MS)
    assert calls == [
        *(("a", 35 * MS), ("b", 35 * MS), ("a", 70 * MS), ("b", 70 * MS)),
        ("before", 70 * MS),
    ]


def test_a_hook_cannot_step(new_world):
    world = new_world()
    world.before_step.append(world.step)
    with pytest.raises(PhysicsError, match="while one is being made"):
        world.step()
    world.before_step.clear()
    world.step()


def test_reset_can_leave_the_clock(new_world, robot_plan, at):
    world = new_world()
    car = world.add(robot_plan("car"), pose=at(z=1.0))
    world.run(SECOND)
    world.reset(time=False)
    assert world.time_ns == SECOND
    assert car.pose.translation == (0.0, 0.0, 1.0)
    assert car.twist == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))


def test_reset_lets_go_of_what_was_commanded(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    for joint in arm.joints.values():
        joint.command_position(0.5)
    world.run(SECOND)
    world.reset()
    assert [joint.position for joint in arm.joints.values()] == [0.0, 0.0]
    world.run(SECOND // 2)
    assert arm.joint("shoulder").position == pytest.approx(3.037881, abs=1e-3)
