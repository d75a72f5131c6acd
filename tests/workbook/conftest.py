"""The workbook of this checkout: a test that asks for `exercise_id` runs for each exercise."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbclient import NotebookClient

from grader.exercises import Exercise, get_exercise, load_exercises

ROOT = Path(__file__).resolve().parents[2]
CELL_SECONDS = 120

Run = Callable[[Path], list[Any]]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "exercise_id" in metafunc.fixturenames:
        metafunc.parametrize("exercise_id", list(load_exercises(ROOT)))


@pytest.fixture(scope="session")
def root() -> Path:
    """Folder of the workbook."""
    return ROOT


@pytest.fixture
def exercise(exercise_id: str) -> Exercise:
    """The exercise that this run of the test is about."""
    return get_exercise(ROOT, exercise_id)


@pytest.fixture
def course(tmp_path: Path) -> Path:
    """A student's checkout: the released exercises and no more, so that nothing of ours is touched."""
    folder = tmp_path / "my course"  # with a space, as people have
    shutil.copytree(ROOT / "exercises", folder / "exercises")
    return folder


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """A function that runs a notebook in its own folder and gives its cells."""
    for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR"):
        monkeypatch.setenv(name, str(tmp_path / name.lower()))
    monkeypatch.delenv("JUPYTER_PATH", raising=False)

    def run_notebook(path: Path) -> list[Any]:
        notebook = nbformat.read(path, as_version=4)
        resources = {"metadata": {"path": str(path.parent)}}
        client = NotebookClient(
            notebook, timeout=CELL_SECONDS, kernel_name="python3", resources=resources
        )
        client.execute()
        return list(notebook.cells)

    return run_notebook
