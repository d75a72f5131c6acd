"""A command at work in a terminal, where no window opens: addresses of pages, and lines that move joints."""

from __future__ import annotations

import urllib.request

import pytest

from simkit import Simulation
from simkit.commands.command import Call
from simkit.commands.table import COMMANDS, run_command
from simkit.live.job import Job

ROBOT = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="hip" type="continuous"><parent link="a"/><child link="b"/></joint></robot>"""
MOVE = "/joint_state_publisher_gui/move"


@pytest.fixture
def sim():
    with Simulation(screen=None) as sim:
        sim.params.set("/robot_description", ROBOT)
        yield sim


def _rosrun(sim, *words):
    call = Call(simulation=sim, words=words, show_window=sim.serve_window_of)
    return Job(call, COMMANDS["rosrun"].load())


def test_each_window_prints_the_address_of_a_page_that_is_there():
    with Simulation(screen=None) as sim:
        for words, mark in (("rviz rviz", b'id="scene"'), ("turtlesim turtlesim_node", b"svg")):
            text = "".join(_rosrun(sim, *words.split()).poll())
            (address,) = [word for word in text.split() if word.startswith("http://127.0.0.1:")]
            with urllib.request.urlopen(address, timeout=10) as answer:
                assert mark in answer.read()


def test_a_window_that_cannot_open_says_how_to_move_its_joints(sim):
    job = _rosrun(sim, "joint_state_publisher_gui", "joint_state_publisher_gui")
    text = "".join(job.poll())
    assert "hint: there is no window with sliders here" in text
    (line,) = [line for line in text.splitlines() if "rostopic pub" in line]
    run_command(sim, "rostopic", ["pub", "-1", *line.split()[4:6], line.split('"')[1]])
    sim.run(0.5)
    assert sim.latest("/joint_states").position == (0.5,)


def test_other_nodes_say_nothing_of_it_and_listen_to_nothing(sim):
    node = sim.rosrun("joint_state_publisher", "joint_state_publisher")
    sim.serve_window_of(node)
    assert [record for record in sim.log if record.level.name == "WARN"] == []
    assert MOVE not in sim.topics()


def test_without_a_terminal_the_gui_listens_to_nothing(sim):
    sim.rosrun("joint_state_publisher_gui", "joint_state_publisher_gui")
    assert MOVE not in sim.topics()


def test_what_a_node_says_while_it_starts_reaches_its_terminal(sim):
    sim.params.delete("/robot_description")
    job = _rosrun(sim, "robot_state_publisher", "robot_state_publisher")
    text = "[ERROR] [1600088400.000000]: Could not find parameter robot_description on parameter server\n"
    assert "".join(job.poll()) == text
    assert job.exit_code == 1
