"""The registry of plugins."""

from __future__ import annotations

import subprocess
import sys

import pytest

from simkit.plugins import Plugin, plugins


@pytest.mark.parametrize("filename", list(plugins()))
def test_each_class_loads(filename):
    entry = plugins()[filename]
    assert entry.filename == filename
    assert issubclass(entry.load(), Plugin)


def test_to_know_the_plugins_is_not_to_load_them():
    modules = [entry.module for entry in plugins().values()]
    program = (
        "import sys\nfrom simkit.plugins import plugins\nplugins()\n"
        f"print([name for name in {modules!r} if name in sys.modules])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"


def test_what_tags_may_say_is_known_without_numpy_or_a_graph():
    program = "import sys, simkit.plugins.registry\nprint(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    loaded = set(done.stdout.split())
    assert not loaded & {"numpy", "simkit.graph", "simkit.physics", "simkit.plugins.plugin"}
