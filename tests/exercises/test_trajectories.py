"""Trajectories that a node sends: the sound ones are taken, and of the others each fault is named."""

import pytest

from grader.errors import CheckFailed
from oracles.driven_arm import COMMAND
from oracles.given_arm import given_arm
from oracles.trajectories import Rules, expect_sound, watch
from simkit import Simulation
from simkit.msgs import Duration, fill_message, message_class

KIND = message_class("trajectory_msgs/JointTrajectory")
RULES = Rules(limits={"hip": (-1.0, 1.0), "elbow": (0.0, 2.0)}, longest=0.5, every=1.0)


def message(*points, names=("elbow", "hip")):
    rows = [
        {"positions": places, "time_from_start": {"secs": 0, "nsecs": round(time * 1e9)}}
        for time, *places in points
    ]
    return fill_message(KIND, {"joint_names": list(names), "points": rows})


def test_a_sound_trajectory_is_taken_whatever_the_order_of_its_names():
    assert expect_sound(message((0.1, 2.0, -1.0), (0.5, 0.5, 0.25)), RULES) == {
        "elbow": 0.5,
        "hip": 0.25,
    }


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (message((0.1, 1.0), (0.2, 1.0), names=["hip"]), "other joints"),
        (message((0.1, 1.0, 1.0), (0.2, 1.0, 1.0), names=["hip", "hip"]), "other joints"),
        (message((0.1, 1.0, 1.0)), "has 1 point$"),
        (message(), "has 0 points"),
        (message((0.0, 1.0, 1.0), (0.2, 1.0, 1.0)), r"points\[0\] of a trajectory comes too early"),
        (message((0.2, 1.0, 1.0), (0.2, 1.0, 1.0)), r"points\[1\] of a trajectory comes too early"),
        (message((0.2, 1.0, 1.0), (0.6, 1.0, 1.0)), r"points\[1\] of a trajectory comes too late"),
        (message((0.1, 1.0), (0.2, 1.0, 1.0)), r"points\[0\] .* has 1 positions for 2 joints"),
        (message((0.1, 1.0, 1.1), (0.2, 1.0, 1.0)), r"points\[0\] .* sends hip beyond"),
        (message((0.1, 1.0, 1.0), (0.2, -0.1, 1.0)), r"points\[1\] .* sends elbow beyond"),
        (message((0.1, float("nan"), 1.0), (0.2, 1.0, 1.0)), "sends elbow beyond"),
    ],
)
def test_each_fault_of_a_trajectory_is_named(wrong, says):
    with pytest.raises(CheckFailed, match=says) as caught:
        expect_sound(wrong, RULES)
    assert caught.value.hint


@pytest.fixture
def arm():
    with Simulation(screen=None) as sim:
        yield given_arm(sim, "hip", "elbow", model="arm")


def send(arm, every, *messages):
    """A node that sends messages one after the other."""
    node = arm.sim.graph.create_node("/wanderer")
    publisher = node.advertise(COMMAND, KIND)
    waiting = list(messages)
    node.create_timer(Duration(every), lambda: waiting and publisher.publish(waiting.pop(0)))


def test_what_was_sent_and_done_is_given_with_its_times(arm):
    first, second = message((0.2, 1.0, 0.5), (0.4, 0.5, -0.5)), message((0.1, 0, 0), (0.5, 1, 1))
    send(arm, 1.0, first, second)
    sent = watch(arm, 2.7, RULES)
    assert [time for time, _ in sent] == pytest.approx([1.0, 2.0])
    assert [one for _, one in sent] == [first, second]
    assert arm.at("elbow", "hip") == pytest.approx((1.0, 1.0), abs=1e-6)


def test_trajectories_that_come_too_often_are_refused(arm):
    sound = message((0.1, 1.0, 0.5), (0.2, 0.5, -0.5))
    send(arm, 0.3, sound, sound)
    with pytest.raises(CheckFailed, match="time from one trajectory to the next"):
        watch(arm, 1.0, RULES)


def test_a_trajectory_that_the_controller_refuses_is_told_with_its_reason(arm):
    refused = message((0.1, 1.0, 0.5), (0.2, 0.5, -0.5))
    refused.points[0].velocities = [0.0]
    send(arm, 0.3, refused)
    with pytest.raises(CheckFailed, match="Size mismatch in trajectory point"):
        watch(arm, 1.0, RULES)
