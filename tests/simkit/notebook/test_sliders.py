from __future__ import annotations

import pytest

ROBOT = """
from simkit import Simulation
sim = Simulation()
sim.params.set("/robot_description", '''<robot name="r"><link name="a"/><link name="b"/>
  <joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint></robot>''')
"""


@pytest.mark.parametrize(
    "line",
    [
        "joint_state_publisher joint_state_publisher _use_gui:=true __name:=gui",
        "joint_state_publisher_gui joint_state_publisher_gui __name:=gui",
    ],
)
def test_a_node_with_sliders_shows_them_below_its_cell(cells, line):
    # A plain shell has no widgets: there the text says how to move a joint, and that works.
    _, started, moved = cells(
        ROBOT,
        f"%rosrun {line}",
        'sim.joint_sliders().set_position("hip", 0.5); print(sim.latest("/joint_states").position)',
    )
    assert started.ok
    assert "Node: /gui\n         hip  0.000 rad = 0.0°\n" in started.out
    assert 'From Python: sim.joint_sliders().set_position("hip", 0.5)' in started.out
    assert moved.out == "(0.5,)\n"


@pytest.mark.parametrize(
    "line",
    [
        "joint_state_publisher joint_state_publisher",
        "joint_state_publisher_gui joint_state_publisher_gui _robot_description:=x",
    ],
)
def test_a_node_without_a_window_or_one_that_has_ended_shows_none(cells, line):
    _, started = cells(ROBOT, f"%rosrun {line}")
    assert started.ok
    assert "Node: /" not in started.out
