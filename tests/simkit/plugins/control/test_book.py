"""Exercise 3.10 of the book, from its launch file to the arm that moves."""

from __future__ import annotations

from pathlib import Path

import pytest

from simkit import Simulation
from simkit.commands.table import run_command
from simkit.physics import NoEngineError
from simkit.physics.engine import dart

ROBOTS = Path(__file__).resolve().parents[4] / "robots"
COMMAND = '{joint_names: ["hip","shoulder"], points: [{positions: [0.1,-0.5], time_from_start: [1.0,0.0]}]}'


@pytest.fixture
def new_sim():
    """Starts the book's launch file; skips where dartpy is not."""
    try:
        dart()
    except NoEngineError as error:
        pytest.skip(str(error))
    simulations = []

    def make():
        sim = Simulation(package_path=[ROBOTS], screen=None)
        simulations.append(sim)
        sim.roslaunch("hello_ros", "spawn_gazebo_2.launch")
        sim.run(1.0)
        return sim

    yield make
    for sim in simulations:
        sim.close()


def publish(sim, text=COMMAND):
    words = ["pub", "/arm_controller/command", "trajectory_msgs/JointTrajectory", text]
    run_command(sim, "rostopic", words, write=lambda _: None)


def positions(sim):
    model = sim.gazebo.spawned["hello_ros_robot"].model
    return [model.joint(name).position for name in ("hip", "shoulder")]


def test_the_books_own_command_moves_the_arm_in_one_second(new_sim):
    sim = new_sim()
    assert positions(sim) == [0.0, 0.0]
    publish(sim)
    sim.run(0.001)
    for tenth in range(11):
        wanted = [0.01 * tenth, -0.05 * tenth]
        assert positions(sim) == pytest.approx(wanted, abs=1e-12)
        sim.run(0.1)
    sim.run(1.0)
    assert positions(sim) == [0.1, -0.5]


def test_the_state_says_the_same_as_the_arm_does(new_sim):
    sim = new_sim()
    states = sim.record(["/arm_controller/state"])
    publish(sim)
    start_ns = sim.now.to_nsec() + 1_000_000
    sim.run(1.5)
    for _, state in states["/arm_controller/state"]:
        part = min((state.header.stamp.to_nsec() - start_ns) / 1e9, 1.0)
        assert list(state.desired.positions) == pytest.approx([0.1 * part, -0.5 * part], abs=1e-12)
        assert list(state.error.positions) == [0.0, 0.0]


def test_the_controller_shows_where_people_look_for_it(new_sim):
    sim = new_sim()
    topics = sim.topics()
    assert topics["/arm_controller/command"] == "trajectory_msgs/JointTrajectory"
    assert topics["/arm_controller/state"] == "control_msgs/JointTrajectoryControllerState"
    goal = topics["/arm_controller/follow_joint_trajectory/goal"]
    assert goal == "control_msgs/FollowJointTrajectoryActionGoal"
    said = [one.text for one in sim.graph.records if one.node == "/controller_spawner"]
    assert said[-1] == "Started controllers: arm_controller"


def test_two_runs_give_the_same_bits(new_sim):
    def run():
        sim = new_sim()
        recording = sim.record(["/joint_states", "/arm_controller/state"])
        publish(sim)
        sim.run(0.7)
        return [recording.raw(topic) for topic in recording.topics()]

    first = run()
    assert all(first)
    assert run() == first
