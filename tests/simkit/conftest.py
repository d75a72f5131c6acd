"""Simulations and scripts for the tests of simkit."""

import textwrap

import pytest

from simkit import Simulation


@pytest.fixture
def package(tmp_path):
    """A function that writes a script into the package `play`, and the folder that holds the package."""
    folder = tmp_path / "play"
    (folder / "scripts").mkdir(parents=True)
    (folder / "package.xml").write_text("<package format='2'><name>play</name></package>")

    def write(name, text):
        (folder / "scripts" / name).write_text(textwrap.dedent(text).lstrip())
        return name

    write.folder = tmp_path
    return write


@pytest.fixture
def sim(package):
    """A silent simulation that finds the package `play`."""
    with Simulation(package_path=[package.folder], screen=None) as simulation:
        yield simulation


@pytest.fixture
def run_script(sim, package):
    """A function that starts a script given as text; its lines after `rospy.init_node` are what it shows."""

    def run(text, *arguments, name="script.py", seconds=0.0, **options):
        package(name, text)
        node = sim.rosrun("play", name, *arguments, **options)
        sim.run(seconds)
        return node

    return run
