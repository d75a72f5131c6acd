from __future__ import annotations

import math

import pytest

from simkit import Simulation
from simkit.errors import SimkitError, UnknownNameError
from simkit.viz import controlled_joints

ROBOT = """<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint>
<joint name="elbow" type="revolute"><parent link="b"/><child link="c"/>
  <limit lower="-1" upper="2" effort="1" velocity="1"/></joint>
<joint name="lift" type="prismatic"><parent link="c"/><child link="d"/>
  <limit lower="0" upper="0.5" effort="1" velocity="1"/></joint></robot>"""


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        sim.params.set("/robot_description", ROBOT)
        sim.params.set("/arm_controller/type", "position_controllers/JointTrajectoryController")
        sim.params.set("/arm_controller/joints", ["lift", "hip", "elbow"])
        yield sim


def test_joints_are_in_the_order_of_the_controller_with_the_limits_of_the_robot(sim):
    found = controlled_joints(sim.graph, "/arm_controller")
    assert [(one.name, one.lower, one.upper, one.unit) for one in found] == [
        ("lift", 0.0, 0.5, "m"),
        ("hip", -math.pi, math.pi, "rad"),
        ("elbow", -1.0, 2.0, "rad"),
    ]
    assert [one.clipped(9.0) for one in found] == [0.5, math.pi, 2.0]
    assert [one.clipped(-9.0) for one in found] == [0.0, -math.pi, -1.0]


def test_a_controller_without_parameters_is_told_with_those_that_have_some(sim):
    with pytest.raises(SimkitError) as caught:
        controlled_joints(sim.graph, "/arm_controler")
    assert str(caught.value).startswith(
        "Could not find 'joints' parameter (namespace: /arm_controler)"
    )
    assert "Trajectory controllers with parameters: /arm_controller." in str(caught.value)


@pytest.mark.parametrize("value", [[], "hip", ["hip", 3], {"a": 1}])
def test_joints_must_be_a_list_of_names(sim, value):
    sim.params.set("/arm_controller/joints", value)
    with pytest.raises(SimkitError, match="a list of names"):
        controlled_joints(sim.graph, "/arm_controller")


def test_without_any_controller_the_remedy_is_told(sim):
    sim.params.delete("/arm_controller")
    with pytest.raises(SimkitError, match=r"No controller has any\. Load the configuration first"):
        controlled_joints(sim.graph, "/arm_controller")


def test_a_joint_that_the_robot_has_not_is_told_with_a_near_one(sim):
    sim.params.set("/arm_controller/joints", ["hipp"])
    with pytest.raises(UnknownNameError, match="hip"):
        controlled_joints(sim.graph, "/arm_controller")


def test_without_a_robot_there_are_no_limits(sim):
    sim.params.delete("/robot_description")
    with pytest.raises(SimkitError, match="/robot_description holds no URDF"):
        controlled_joints(sim.graph, "/arm_controller")
