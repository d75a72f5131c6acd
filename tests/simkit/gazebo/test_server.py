"""The world on the clock of a simulation."""

from __future__ import annotations

import math

import pytest

from simkit import SimkitError, Simulation
from simkit.gazebo import SpawnError
from simkit.geometry import Transform

BALL = """<robot name="ball"><link name="ball">
  <inertial><mass value="1"/><inertia ixx="0.004" iyy="0.004" izz="0.004" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""
EMPTY = '<robot name="empty"><link name="base"/></robot>'


def at(x=0.0, y=0.0, z=0.0):
    return Transform((x, y, z))


def texts(sim):
    return [record.text for record in sim.log]


def test_a_simulation_has_a_world_when_it_is_asked_for_one(sim):
    assert not sim.has_world
    assert list(sim.gazebo.spawned) == ["ground_plane"]
    assert sim.has_world
    assert sim.gazebo is sim.gazebo
    assert "/gazebo" in sim.nodes()
    assert sim.params.get("/use_sim_time") is True


def test_time_begins_at_0_with_a_world_and_never_jumps_once_it_runs():
    with Simulation(screen=None) as first, Simulation(screen=None) as second:
        assert first.gazebo.world.time_ns == 0
        assert first.now.to_sec() == 0.0
        second.run(0.25)
        before = second.now
        assert second.gazebo.world.time_ns == 0
        assert second.now == before
        second.run(0.1)
        assert second.world.time_ns == 100_000_000
        assert (second.now - before).to_sec() == 0.1


def test_a_ball_falls_as_a_ball_does(sim, gazebo):
    gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0))
    sim.run(0.5)
    z = gazebo.world.model("ball").pose.translation[2]
    assert z == pytest.approx(5.0 - 9.8 * 0.5**2 / 2, abs=2e-3)


def test_events_see_the_world_as_it_is_at_their_time(sim, gazebo):
    ball = gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0)).model
    executor = sim.graph.executor
    seen = []
    for time_ns in (100_000_000, 200_500_000):
        executor.call_at(time_ns, lambda: seen.append((sim.now.to_nsec(), sim.world.time_ns)))
    sim.run(1.0)
    assert seen == [(100_000_000, 100_000_000), (200_500_000, 200_000_000)]
    assert ball.pose.translation[2] < 1.0


def test_what_a_step_publishes_is_delivered_at_once(sim, gazebo):
    heard = []
    from simkit.msgs import message_class

    clock = message_class("rosgraph_msgs/Clock")
    node = sim.graph.create_node("/listener")
    node.subscribe(
        "/clock", clock, lambda message: heard.append((message.clock.to_nsec(), sim.now.to_nsec()))
    )
    sim.run(0.003)
    assert heard == [(ns, ns) for ns in (1_000_000, 2_000_000, 3_000_000)]
    assert gazebo.world.time_ns == 3_000_000


def test_a_run_that_waits_for_the_world_stops_within_a_step(sim, gazebo):
    ball = gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0)).model
    assert sim.run_until(lambda: ball.pose.translation[2] < 4.0, timeout=2.0)
    assert sim.now.to_sec() == pytest.approx(math.sqrt(2.0 / 9.8), abs=2e-3)
    assert not sim.run_until(lambda: False, timeout=0.1)


def test_it_stands_still_while_paused_and_goes_on_from_there(sim, gazebo):
    ball = gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0)).model
    sim.run(0.1)
    gazebo.pause()
    before = ball.pose
    sim.run(0.25)
    assert (ball.pose, sim.now.to_sec()) == (before, 0.35)
    gazebo.unpause()
    sim.run(0.1)
    assert gazebo.world.time_ns == 200_000_000
    assert ball.pose.translation[2] < before.translation[2]


def test_a_reset_puts_models_back_and_the_clock_goes_on(sim, gazebo):
    ball = gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0)).model
    sim.run(0.3)
    first = ball.pose
    gazebo.reset_simulation()
    assert ball.pose == at(z=5.0)
    assert gazebo.world.time_ns == 0
    sim.run(0.3)
    assert ball.pose == first
    assert sim.now.to_sec() == 0.6


def test_the_same_runs_give_the_same_bits_however_they_are_divided():
    ends = []
    for pieces in (1, 7):
        with Simulation(seed=3, screen=None) as sim:
            ball = sim.gazebo.spawn_urdf(BALL, name="ball", pose=at(z=0.3)).model
            for _ in range(pieces):
                sim.run(0.7 / pieces)
            sim.run_until(lambda sim=sim: sim.now.to_nsec() >= 700_000_000, timeout=1.0)
            ends.append(ball.pose)
    assert ends[0] == ends[1]


def test_a_name_that_is_taken_is_refused_with_what_to_do(gazebo):
    gazebo.spawn_urdf(BALL, name="ball", pose=at(z=1.0))
    with pytest.raises(SpawnError, match="delete it first") as caught:
        gazebo.spawn_urdf(BALL, name="ball", pose=at(z=2.0))
    assert caught.value.status == "SpawnModel: Failure - entity already exists."
    gazebo.delete("ball")
    gazebo.spawn_urdf(BALL, name="ball", pose=at(z=2.0))
    assert gazebo.world.model("ball").pose == at(z=2.0)


def test_a_model_can_come_in_beside_another(gazebo):
    gazebo.spawn_urdf(BALL, name="first", pose=at(x=1.0, z=1.0))
    second = gazebo.spawn_urdf(BALL, name="second", pose=at(x=0.5), reference_frame="first")
    third = gazebo.spawn_urdf(BALL, name="third", pose=at(y=1.0), reference_frame="first::ball")
    assert second.model.pose.translation == pytest.approx((1.5, 0.0, 1.0))
    assert third.model.pose.translation == pytest.approx((1.0, 1.0, 1.0))
    with pytest.raises(SpawnError, match=r"reference_frame not found.*'fist'.*first, second"):
        gazebo.spawn_urdf(BALL, name="fourth", reference_frame="fist")


@pytest.mark.parametrize(
    "text", ["", "<robot", "<sdf/>", '<robot name="x"><link name="a"/><link name="b"/></robot>']
)
def test_what_is_no_robot_is_refused_and_nothing_is_left(gazebo, text):
    with pytest.raises(SpawnError, match="entity format is invalid"):
        gazebo.spawn_urdf(text, name="bad")
    assert list(gazebo.world.models) == ["ground_plane"]


def test_a_robot_without_mass_is_an_empty_model_and_that_is_said(sim, gazebo):
    gazebo.spawn_urdf(EMPTY, name="empty")
    assert any("empty model" in text for text in texts(sim))
    sim.run(0.1)
    assert "empty" in gazebo.spawned


def test_spawn_takes_files_and_texts(sim, tmp_path):
    file = tmp_path / "ball.urdf"
    file.write_text(BALL)
    assert sim.spawn(file, xyz=(0, 0, 1)).name == "ball"
    assert sim.spawn(BALL, name="other", xyz=(1, 0, 1)).model.pose.translation == (1, 0, 1)
    sdf = "<sdf version='1.6'><model name='box'><link name='l'/></model></sdf>"
    assert sim.spawn(sdf).sdf.name == "box"
    with pytest.raises(SimkitError, match="no model: it begins with <launch>"):
        sim.spawn("<launch/>")
    with pytest.raises(SimkitError, match=r"ball\.udrf cannot be read"):
        sim.spawn(tmp_path / "ball.udrf")


def test_when_the_node_ends_the_world_stands_still(sim, gazebo):
    ball = gazebo.spawn_urdf(BALL, name="ball", pose=at(z=5.0)).model
    gazebo.node.shutdown()
    before = ball.pose
    sim.run(0.1)
    assert ball.pose == before
    assert not sim.has_world
    assert sim.gazebo is not gazebo


def test_a_model_that_flies_apart_is_taken_out_and_time_goes_on(sim, gazebo):
    gazebo.spawn_urdf(BALL, name="good", pose=at(z=0.1))
    wild = gazebo.spawn_urdf(BALL, name="wild", pose=at(x=5.0, z=1.0)).model
    gazebo.world.before_step.append(
        lambda: wild.push("ball", force=(1e9, 0.0, 0.0)) if "wild" in gazebo.world.models else None
    )
    sim.run(1.0)
    assert sim.now.to_sec() == 1.0
    assert gazebo.world.time_ns == 1_000_000_000
    assert list(gazebo.spawned) == ["ground_plane", "good"]
    assert sum("flew apart" in text for text in texts(sim)) == 1
