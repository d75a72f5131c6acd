"""A copy of the tree, in which a recipe of CONTRIBUTING is followed by its text."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("simkit", "grader", "tests", "exercises", "solutions", "robots", "docs")
MOST_PLACES = 3
"""So many places may be touched by hand."""


class Tree:
    """A copy of the checkout, and the places in it that were written by hand."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.touched: set[str] = set()
        skipped = shutil.ignore_patterns("__pycache__", "*.pyc")
        for name in FOLDERS:
            shutil.copytree(ROOT / name, folder / name, ignore=skipped)
        for path in (*ROOT.glob("*.md"), ROOT / "pyproject.toml"):
            shutil.copy(path, folder)

    def write(self, name: str, text: str) -> None:
        """A new file."""
        path = self.folder / name
        assert not path.exists()
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        self.touched.add(name)

    def insert(self, name: str, before: str, text: str) -> None:
        """An entry of a table that is there, in front of the first place of a text."""
        path = self.folder / name
        old = path.read_text(encoding="utf-8")
        assert before in old, f"{name} has no {before!r}"
        path.write_text(old.replace(before, text + before, 1), encoding="utf-8")
        self.touched.add(name)

    def run(self, command: str) -> str:
        """What a command of the recipe prints; it must work."""
        program, *words = [word.strip("'\"") for word in re.findall(r'"[^"]*"|\S+', command)]
        start = {
            "pytest": ["-m", "pytest", "-q"],
            "grader": ["-P", "-m", "grader.cli"],
            "python": [],
        }[program]
        # An exercise adds no code: the installed grader looks at the copy, and its nodes find their simkit.
        ours = {} if program == "grader" else {"PYTHONPATH": str(self.folder)}
        environment = {**os.environ, **ours}
        done = subprocess.run(
            [sys.executable, *start, *words],
            cwd=self.folder,
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    def prove(self, what: str, **names: str) -> None:
        """Run the test command that CONTRIBUTING gives for such an addition; few places may be touched."""
        assert len(self.touched) <= MOST_PLACES, self.touched
        said = self.run(recipe(what).format(**names))
        assert " passed" in said or "sound" in said


def recipe(what: str) -> str:
    """The test command of a row of the table of recipes, with its placeholders in braces."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (an? [\w ]+) \|.*\| `([^`]+)` \|$", text, re.MULTILINE)
    return re.sub(r"\b(NAME|ID)\b", r"{\1}", dict(rows)[what])


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    return Tree(tmp_path / "workbook")
