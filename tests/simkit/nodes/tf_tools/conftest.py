from __future__ import annotations

import pytest

from simkit import Simulation


@pytest.fixture
def sim(tmp_path):
    with Simulation(package_path=[tmp_path], screen=None) as simulation:
        yield simulation


@pytest.fixture
def said(sim):
    """Lines of the log of a level."""
    return lambda level: [record.text for record in sim.log if record.level.name == level]


@pytest.fixture
def rosrun(sim):
    """Starts a node by its command line, `tf tf_echo world a`."""
    return lambda line: sim.rosrun(*line.split())
