"""The registry of plugins."""

from __future__ import annotations

import subprocess
import sys

import pytest

from simkit.plugins import Plugin, plugins
from simkit.urdf.rules.plugin_words import PLUGINS, Place

PLACES = {None: Place.MODEL, "ray": Place.RAY, "imu": Place.IMU, "contact": Place.CONTACT}


@pytest.mark.parametrize("filename", list(plugins()))
def test_each_class_loads_and_stands_where_check_urdf_says(filename):
    entry = plugins()[filename]
    assert entry.filename == filename
    assert issubclass(entry.load(), Plugin)
    assert PLUGINS[filename].place is PLACES[entry.sensor]


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
