"""The robot on which a node that drives an arm is judged."""

import pytest

from grader.checks.log import complaint
from oracles.given_arm import given_arm
from simkit import Simulation


def test_its_controller_runs_and_it_tells_of_its_joints():
    with Simulation(screen=None) as sim:
        arm = given_arm(sim, "hip", "shoulder", "elbow", model="arm")
        assert arm.joints == ("elbow", "hip", "shoulder")
        (controller,) = sim.call("/controller_manager/list_controllers").controller
        assert (controller.name, controller.state) == ("arm_controller", "running")
        arm.command((0.1, {"hip": 0.3, "elbow": -0.2}))
        sim.run(0.15)
        assert arm.at("hip", "shoulder", "elbow") == pytest.approx((0.3, 0.0, -0.2), abs=1e-3)
        told = sim.latest("/joint_states")
        assert dict(zip(told.name, told.position, strict=True)) == pytest.approx(
            {"hip": 0.3, "shoulder": 0.0, "elbow": -0.2}, abs=1e-3
        )
        assert sim.tf.can_transform("world", "elbow_ball")
        assert complaint(sim) == ""
