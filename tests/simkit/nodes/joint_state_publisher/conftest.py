"""Robots made of joints, and publishers that speak of them."""

from __future__ import annotations

from typing import Any

import pytest

from simkit import Simulation


class Stage:
    """A silent simulation with a robot on its parameter server."""

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.states = sim.record({"/joint_states": "sensor_msgs/JointState"})

    def turning(self, name: str, inside: str = "") -> str:
        return f'<joint name="{name}" type="continuous">{{}}{inside}</joint>'

    def limited(self, name: str, lower: float, upper: float, inside: str = "") -> str:
        limit = f'<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'
        return f'<joint name="{name}" type="revolute">{{}}{limit}{inside}</joint>'

    def robot(self, *joints: str) -> str:
        """A chain of links; `{}` in a joint becomes its parent and its child."""
        links = "".join(f'<link name="l{number}"/>' for number in range(len(joints) + 1))
        filled = "".join(
            joint.replace("{}", f'<parent link="l{number}"/><child link="l{number + 1}"/>')
            for number, joint in enumerate(joints)
        )
        return f'<?xml version="1.0"?><robot name="r">{links}{filled}</robot>'

    def load(self, *joints: str, **parameters: object) -> None:
        self.sim.params.set("/robot_description", self.robot(*joints))
        for name, value in parameters.items():
            self.sim.params.set(f"/{name}", value)

    def start(self, *words: str, gui: bool = False) -> Any:
        package = "joint_state_publisher_gui" if gui else "joint_state_publisher"
        return self.sim.rosrun(package, package, *words)

    def state(self) -> dict[str, float]:
        """Positions by name in the newest message, after one more of them was sent."""
        self.sim.run(0.1)
        latest: Any = self.sim.latest("/joint_states")
        return dict(zip(latest.name, latest.position, strict=True))

    def said(self, level: str) -> list[str]:
        return [record.text for record in self.sim.log if record.level.name == level]


@pytest.fixture
def stage():
    with Simulation(seed=1, screen=None) as sim:
        yield Stage(sim)
