"""Cells of a notebook, run by a real IPython shell in a process of its own."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import dataclass

import pytest

PROGRAM = """
import contextlib, io, json, sys
from IPython.core.interactiveshell import InteractiveShell
from traitlets.config import Config

config = Config()
config.HistoryManager.enabled = False
config.InteractiveShell.colors = "nocolor"
shell = InteractiveShell(config=config)
shell.show_rewritten_input = False
results = []
for cell in json.load(sys.stdin):
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        done = shell.run_cell(cell, store_history=False)
    results.append([out.getvalue(), err.getvalue(), done.success])
print(json.dumps(results))
"""


@dataclass(frozen=True, slots=True)
class Shown:
    """What stands below a cell."""

    out: str
    err: str
    ok: bool


@pytest.fixture
def cells(tmp_path):
    """Runs cells in a folder with the package `hello_ros`; gives what each shows."""
    scripts = tmp_path / "hello_ros" / "scripts"
    scripts.mkdir(parents=True)
    (tmp_path / "hello_ros" / "package.xml").write_text("<package/>")

    def run(*texts, **files):
        for name, text in files.items():
            (scripts / f"{name}.py").write_text(text)
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM],
            input=json.dumps(["%load_ext simkit", *texts]),
            capture_output=True,
            text=True,
            cwd=tmp_path,
            env={**os.environ, "IPYTHONDIR": str(tmp_path / "ipython")},
            check=True,
        )
        assert done.stderr == ""
        first, *shown = [Shown(*result) for result in json.loads(done.stdout)]
        assert first == Shown("", "", True)
        return shown

    return run
