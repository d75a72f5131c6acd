from __future__ import annotations

import pytest

from simkit import Simulation
from simkit.live.commands import live_commands
from simkit.live.moving import offer_moves

ROBOT = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint></robot>"""
MOVE = "/joint_state_publisher_gui/move"


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        sim.params.set("/robot_description", ROBOT)
        yield sim


def test_a_window_that_cannot_open_says_how_to_move_its_joints(sim):
    rosrun = live_commands()["rosrun"]
    job = rosrun(sim, ["joint_state_publisher_gui", "joint_state_publisher_gui"])
    text = job.poll()
    assert "hint: there is no window with sliders here" in text
    (line,) = [line for line in text.splitlines() if "rostopic pub" in line]
    pub = live_commands()["rostopic"]
    pub(sim, ["pub", "-1", *line.split()[4:6], line.split('"')[1]])
    sim.run(0.5)
    assert sim.latest("/joint_states").position == (0.5,)


def test_other_nodes_say_nothing_of_it_and_listen_to_nothing(sim):
    nodes = [
        sim.rosrun("joint_state_publisher", "joint_state_publisher"),
        sim.rosrun("turtlesim", "turtlesim_node"),
    ]
    offer_moves(nodes)
    assert [record for record in sim.log if record.level.name == "WARN"] == []
    assert MOVE not in sim.topics()


def test_without_a_terminal_the_gui_listens_to_nothing(sim):
    sim.rosrun("joint_state_publisher_gui", "joint_state_publisher_gui")
    assert MOVE not in sim.topics()


def test_what_a_node_says_while_it_starts_reaches_its_terminal(sim):
    sim.params.delete("/robot_description")
    job = live_commands()["rosrun"](sim, ["robot_state_publisher", "robot_state_publisher"])
    text = "[ERROR] [1600088400.000000]: Could not find parameter robot_description on parameter server\n"
    assert job.poll() == text
    assert job.exit_code == 1
