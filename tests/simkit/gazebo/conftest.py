"""A world, and small models to put into it."""

from __future__ import annotations

import pytest

from simkit import Simulation
from simkit.geometry import Transform

BALL = """<robot name="ball"><link name="ball">
  <inertial><mass value="1"/><inertia ixx="0.004" iyy="0.004" izz="0.004" ixy="0" ixz="0" iyz="0"/></inertial>
  <collision><geometry><sphere radius="0.1"/></geometry></collision>
</link></robot>"""
WHEEL = """<robot name="wheel"><link name="world"/><link name="wheel">
  <inertial><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
</link><joint name="axle" type="continuous"><parent link="world"/><child link="wheel"/>
  <origin xyz="0 0 1"/><axis xyz="0 0 1"/></joint></robot>"""


@pytest.fixture
def sim():
    """A silent simulation."""
    with Simulation(seed=1, screen=None) as made:
        yield made


@pytest.fixture
def gazebo(sim):
    """Its empty world."""
    return sim.gazebo


def at(x=0.0, y=0.0, z=0.0, yaw=0.0):
    """A placement."""
    return Transform.from_rpy((x, y, z), (0.0, 0.0, yaw))
