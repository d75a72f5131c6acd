"""A ROS package of one script, for the benchmarks that start nodes."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Iterator
from pathlib import Path

from simkit import Simulation


@contextlib.contextmanager
def simulation_with(script: str) -> Iterator[Simulation]:
    """A silent simulation that finds the package `play` with `script.py`."""
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder) / "play"
        package.mkdir()
        (package / "package.xml").write_text("<package format='2'><name>play</name></package>")
        (package / "script.py").write_text(script)
        with Simulation(package_path=[folder], screen=None) as sim:
            yield sim
