from __future__ import annotations

import pytest

from simkit import Simulation
from simkit.commands.command import Bounds
from simkit.commands.errors import ToolError
from simkit.commands.table import run_command


@pytest.fixture
def sim(tmp_path):
    """A silent simulation with a turtlesim."""
    with Simulation(package_path=[tmp_path], screen=None) as simulation:
        simulation.rosrun("turtlesim", "turtlesim_node")
        simulation.run(0.1)
        yield simulation


@pytest.fixture
def command(sim):
    """What a command line, given as words, prints."""

    def run(*words, seconds=5.0, messages=None):
        printed = []
        bounds = Bounds(seconds=seconds, messages=messages)
        run_command(sim, words[0], words[1:], write=printed.append, bounds=bounds)
        return "".join(printed)

    return run


@pytest.fixture
def refusal(command):
    """What a command line that fails says, and its exit code."""

    def run(*words, **settings):
        with pytest.raises(ToolError) as caught:
            command(*words, **settings)
        return str(caught.value), caught.value.exit_code

    return run


@pytest.fixture
def rosrun(sim):
    """Starts a node by its command line, `tf tf_echo world a`."""
    return lambda line: sim.rosrun(*line.split())
