"""Command lines: in this process where it is enough, in one of their own where it matters."""

import os
import signal
import subprocess
import sys

import pytest

from simkit.cli import main


@pytest.fixture(autouse=True)
def own_session(tmp_path, monkeypatch):
    """No test finds the simulation of another one, or of a person at this machine."""
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))


@pytest.fixture
def simkit(capfd):
    """A function that runs a command line here: (exit code, output, error output)."""

    def run(*words):
        code = main(words)
        captured = capfd.readouterr()
        return code, captured.out, captured.err

    return run


@pytest.fixture
def begin(tmp_path):
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
