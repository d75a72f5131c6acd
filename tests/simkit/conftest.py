"""Simulations and scripts for the tests of simkit."""

import importlib.util
import textwrap
from pathlib import Path

import pytest

from simkit import Simulation
from simkit.nodes.turtlesim import Frame


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


@pytest.fixture(scope="session")
def mutated():
    """`mutated(text, rng)` of `xml/mutations.py`: the text in bytes, spoiled in one to four places."""
    path = Path(__file__).parent / "xml/mutations.py"
    spec = importlib.util.spec_from_file_location("xml_mutations", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.mutated


@pytest.fixture
def frame():
    """A window of turtlesim with turtle1 in its centre."""
    frame = Frame()
    frame.spawn()
    return frame


@pytest.fixture
def drive_turtle():
    """Updates a frame so many times, with a fresh command for one turtle before each."""
    now_ns = 0

    def drive(frame, ticks, velocity=None, turtle="turtle1"):
        nonlocal now_ns
        readings = []
        for _ in range(ticks):
            now_ns += 16_000_000
            if velocity is not None:
                frame.turtle(turtle).command(velocity)
            by_name = {moved.name: reading for moved, reading in frame.update(now_ns)}
            readings.append(by_name[turtle])
        return readings

    return drive
