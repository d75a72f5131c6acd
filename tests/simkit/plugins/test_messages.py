"""The message of joint states."""

from __future__ import annotations

import pytest

from simkit.msgs import Time
from simkit.plugins.messages import joint_state_message
from tests.simkit.plugins.samples import CAR


@pytest.fixture
def joints(stage):
    """Two wheels in the air, one of which turns."""
    model = stage.spawn(CAR, pose=stage.at(z=3.0)).model
    left, right = model.joint("left_joint"), model.joint("right_joint")
    left.set_position(7.0)
    left.set_velocity(2.0)
    return [right, left]


def test_joints_are_told_in_the_order_in_which_they_are_given(joints):
    message = joint_state_message(joints, Time(3), with_velocities=True)
    assert message.name == ["right_joint", "left_joint"]
    assert list(message.position) == [0.0, 7.0]
    assert list(message.velocity) == [0.0, 2.0]
    assert list(message.effort) == []
    assert message.header.stamp == Time(3)
    message.to_bytes()


def test_velocities_may_be_left_out(joints):
    assert list(joint_state_message(joints, Time(3), with_velocities=False).velocity) == []
