"""A robot with a controller: started, commanded, and what is said when it cannot be."""

from pathlib import Path

import pytest

from grader.checks.log import complaint
from grader.errors import CheckFailed
from oracles.driven_arm import started_arm
from oracles.given_arm import given_arm
from simkit import Simulation

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
MODEL = "hello_ros_robot"


@pytest.fixture
def sim():
    with Simulation(screen=None, package_path=[ROBOTS]) as simulation:
        yield simulation


def start(sim, *joints, file="spawn_gazebo_2.launch", model=MODEL):
    return started_arm(
        sim, lambda name: sim.roslaunch("hello_ros", name), file, model=model, joints=joints
    )


def test_the_arm_of_the_book_is_started_and_goes_where_it_is_told(sim):
    arm = start(sim, "hip", "shoulder")
    assert arm.joints == ("hip", "shoulder")
    arm.command((0.1, {"shoulder": -0.2}), (0.2, {"hip": 0.3}), order=["shoulder", "hip"])
    sim.run(0.1)
    arm.expect_at({"hip": 0.0, "shoulder": -0.2}, when="at the first point", hint="")
    sim.run(0.1)
    arm.expect_at({"hip": 0.3, "shoulder": 0.0}, when="at the last point", hint="")
    with pytest.raises(CheckFailed, match="angle of hip a moment later") as caught:
        arm.expect_at({"hip": 0.35}, when="a moment later", hint="look")
    assert caught.value.hint == "look"
    with pytest.raises(CheckFailed, match="no joint elbow"):
        arm.at("elbow")


def test_what_is_missing_is_named(sim):
    with pytest.raises(CheckFailed, match=r"arm is not in the world.*: hello_ros_robot"):
        start(sim, model="arm")
    with pytest.raises(CheckFailed, match="does not move elbow"):
        start(sim, "elbow")
    with pytest.raises(CheckFailed, match="there is no controller manager"):
        start(sim, file="spawn_gazebo_1.launch")


def test_a_controller_that_cannot_be_loaded_is_told_with_its_log(sim):
    sim.roslaunch("hello_ros", "spawn_gazebo_2.launch")
    sim.params.set("/arm_controller/joints", ["hip", "elbow"])
    with pytest.raises(CheckFailed, match="arm_controller does not run") as caught:
        started_arm(sim, lambda _: None, "arm.launch", model=MODEL, joints=("hip",))
    assert "Could not find joint 'elbow'" in caught.value.message
    assert "hint: the joints that move are: hip, shoulder" in caught.value.message


def test_a_refused_trajectory_is_a_complaint_and_advice_alone_is_none(sim):
    arm = given_arm(sim, "hip", "elbow", model=MODEL)
    assert complaint(sim) == ""
    arm.command((0.1, {"hip": 0.1}), (0.1, {"hip": 0.2}))
    assert complaint(sim).startswith("Trajectory message contains waypoints that are not strictly")
    assert "hint: points[1] comes at 0.1 s" in complaint(sim)
