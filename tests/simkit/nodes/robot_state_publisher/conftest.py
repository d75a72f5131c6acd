"""Robots, and joint states with any stamp."""

from __future__ import annotations

from typing import Any

import pytest

from simkit import Simulation
from simkit.msgs import Duration, Time, message_class

ARM = """<?xml version="1.0"?>
<robot name="arm">
  <link name="world"/>
  <link name="base"/>
  <link name="torso"/>
  <link name="hand"/>
  <joint name="fixed" type="fixed"><parent link="world"/><child link="base"/></joint>
  <joint name="shoulder" type="continuous">
    <parent link="torso"/><child link="hand"/>
    <axis xyz="0 1 0"/><origin rpy="0 1.5708 0" xyz="0.0 -0.1 0.45"/>
  </joint>
  <joint name="hip" type="continuous">
    <parent link="base"/><child link="torso"/>
    <axis xyz="0 0 1"/><origin xyz="0 0 0.05"/>
  </joint>
</robot>
"""


class Stage:
    """A silent simulation with a robot and somebody who says where its joints are."""

    arm = ARM

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.messages = sim.record(
            {"/tf": "tf2_msgs/TFMessage", "/tf_static": "tf2_msgs/TFMessage"}
        )
        self._node = sim.graph.create_node("/joints")
        self._publisher: Any = None

    def load(self, text: str = ARM, **parameters: object) -> None:
        self.sim.params.set("/robot_description", text)
        for name, value in parameters.items():
            self.sim.params.set(f"/{name}", value)

    def start(self, *words: str) -> Any:
        return self.sim.rosrun("robot_state_publisher", "robot_state_publisher", *words)

    def tell(self, stamp: Time | None = None, **positions: float) -> None:
        """Publish positions, stamped with this moment unless told otherwise."""
        self.tell_raw(list(positions), list(positions.values()), stamp)

    def tell_raw(self, names: list[str], positions: list[float], stamp: Time | None = None) -> None:
        joint_state: Any = message_class("sensor_msgs/JointState")
        if self._publisher is None:
            self._publisher = self._node.advertise("/joint_states", joint_state)
        message = joint_state(name=names, position=positions)
        message.header.stamp = self.sim.now if stamp is None else stamp
        self._publisher.publish(message)
        self.sim.run(0.0)

    def heard(self, topic: str = "/tf") -> list[list[Any]]:
        """The transforms of each message so far."""
        return [list(message.transforms) for _, message in self.messages[topic]]

    def said(self, level: str) -> list[str]:
        return [record.text for record in self.sim.log if record.level.name == level]

    def pace(self, period: float, seconds: float, jitter: Any = lambda: 0.0) -> int:
        """How many messages come of joint states every `period` [s] for `seconds` [s]."""
        before = len(self.messages["/tf"])
        for _ in range(round(seconds / period)):
            self.sim.run(period)
            stamp = self.sim.now + Duration.from_nsec(round(jitter() * 1e9))
            self.tell(stamp, hip=0.1, shoulder=0.2)
        return len(self.messages["/tf"]) - before


@pytest.fixture
def stage():
    with Simulation(seed=1, screen=None) as sim:
        yield Stage(sim)
