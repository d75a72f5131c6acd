"""Simulations and scripts for the tests of simkit."""

import importlib.util
import os
import signal
import subprocess
import sys
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


@pytest.fixture
def own_session(tmp_path, monkeypatch):
    """No test finds the simulation of another one, or of a person at this machine."""
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))


@pytest.fixture
def simkit(capfd, own_session):
    """A function that runs a command line here: (exit code, output, error output)."""

    from simkit.cli import main

    def run(*words):
        code = main(words)
        captured = capfd.readouterr()
        return code, captured.out, captured.err

    return run


@pytest.fixture
def begin(tmp_path, own_session):
    """A function that begins a command line as a process of its own; all are ended afterwards."""
    processes = []

    def begin(*words, folder=None):
        process = subprocess.Popen(
            [sys.executable, "-m", "simkit.cli", *words],
            cwd=folder or tmp_path,
            env=os.environ.copy(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            # Tests that run in the background of a shell ignore Ctrl-C, and so would this one.
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        )
        processes.append(process)
        return process

    yield begin
    for process in processes:
        process.kill()
        process.communicate()
